#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

/// The mean of Monte Carlo estimates, by the test of stochastic.hpp: pictures of bytes (sRGB) or floats (light), and
/// tables whose rows are replicates and whose components are quantities. Right if noise explains the worst deviation
/// with at least check_alpha(); else the credit falls with the share of the light in the wrong place.
[[nodiscard]] Judgement judge_noise(const Check& check, const Tensor& student, const Tensor& expected,
                                    const Tensor* names);

}
