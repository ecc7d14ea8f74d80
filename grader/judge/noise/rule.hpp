#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

/// What a check of noise takes beside what all take.
struct NoiseParameters {
    /// How many times as widely as the reference's, in standard deviations, estimates may scatter where that hides a
    /// bias of a tenth: at least twice what right estimators of other kinds need, and no more than that, since a wide
    /// scatter hides what is wrong with the mean.
    double scatter = 3;
};

/// The mean of Monte Carlo estimates, by the test of stochastic.hpp: pictures of bytes (sRGB) or floats (light), and
/// tables whose rows are replicates and whose components are quantities. Right if noise explains the worst deviation
/// with at least check_alpha(); else the credit falls with the share of the light in the wrong place.
[[nodiscard]] Judgement judge_noise(const Check& check, const Tensor& student, const Tensor& expected,
                                    const Tensor* names);

}
