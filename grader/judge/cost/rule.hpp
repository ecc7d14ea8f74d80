#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

/// Rows (size, blocks): the exponent with which the student's count grows. Right up to check.growth + 0.15, falling to
/// 0 at + 0.6; worth nothing where next to no work was done, since a function that returns at once grows with nothing.
[[nodiscard]] Judgement judge_cost(const Check& check, const Tensor& student, const Tensor& expected,
                                   const Tensor* names);

}
