#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

/// Rows [primitive, x, y, attributes...], matched by their place. The fraction is matched / (expected + extra +
/// duplicated); what lies one pixel aside with its whole primitive is in the wrong place, and neither missing nor
/// extra. Without a tolerance attributes are equal or wrong. `with_sketch` draws the first bad place.
[[nodiscard]] Judgement judge_fragments(const Check& check, const Tensor& student, const Tensor& expected,
                                        const Tensor* names, bool with_sketch);

}
