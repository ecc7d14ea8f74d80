#pragma once

#include "judge/noise/rule.hpp"
#include "noisy.hpp"

/// What a correct path tracer, or one that is a factor off, records.
namespace umbral::grader::test {

inline constexpr std::uint64_t seed = 20260401;

inline Check noise_check(double scatter = 30)
{
    Check check = check_of(JudgeKind{"noise"});
    check.own = NoiseParameters{scatter};
    return check;
}

inline const Check check = noise_check();

/// floor_and_ball times a factor, 32 samples a pixel of a smooth integrand, in colour.
inline Tensor run(Random& random, double factor = 1)
{
    return noisy(
        random, 64, 64, 3, 32, [factor](int x, int y) { return factor * floor_and_ball(x, y); }, uniform);
}

/// Replicates of four estimates, the given factor off.
inline Tensor estimates(Random& random, double factor = 1, int rows = 400)
{
    std::vector<double> values;
    for (int row = 0; row < rows; ++row)
        for (const double mean : {0.5, 2.0, 30.0, 0.01})
            values.push_back(factor * mean * mean_of(random, exponential, 16));
    return doubles(values, 4);
}

}
