#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

/// Calls of OpenGL, counted by the check's rules against the expected ones; the fraction of the rules that hold. Worth
/// nothing if nothing is drawn where the expected trace draws.
[[nodiscard]] Judgement judge_trace(const Check& check, const Tensor& student, const Tensor& expected);

}
