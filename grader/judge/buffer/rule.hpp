#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

/// Cells are equal exactly, or within the tolerance if one is given. The background is the most frequent cell of the
/// expected border; the fraction is of the cells where either side differs from it, so that a mostly empty buffer hides
/// nothing. `with_classes` says where the wrong cells lie, whose values they hold and what rule they follow, and draws
/// the first bad place.
[[nodiscard]] Judgement judge_buffer(const Check& check, const Tensor& student, const Tensor& expected,
                                     bool with_classes);

}
