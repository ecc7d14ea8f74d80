#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

/// Rows [code, numbers...], aligned in order so that what is lost or too much costs itself only: 2 matches / (yours +
/// expected).
[[nodiscard]] Judgement judge_events(const Check& check, const Tensor& student, const Tensor& expected,
                                     const Tensor* names);

}
