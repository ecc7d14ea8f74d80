#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "judge/statistics/stochastic.hpp"
#include "noise_runs.hpp"
#include "support/all_tests.hpp"

namespace umbral::grader::test {

inline Estimates noisy_estimates(Random& random, int samples, Noise noise, const Light& light = floor_and_ball)
{
    Estimates made{32, 32, 1, true, {}, {}};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) made.values.push_back(light(2 * x, 2 * y) * mean_of(random, noise, samples));
    return made;
}

/// What is judged of pair number i of right pictures; each has a p-value.
using SumsOfPair = std::function<std::vector<TileSums>(const Estimates&, const Estimates&, int i)>;

/// Expects p-values below x with a chance of x at most, or so many times that (sums of few terms take few values:
/// tail_factor is what is charged), for noise of several kinds, and for estimates of two kinds.
inline void expect_uniform(const char* of_what, const SumsOfPair& sums_of_pair, double most = 1.05)
{
    SCOPED_TRACE(test::seed);
    Random random(test::seed + 7);
    const int pairs = samples_for_tests(10000);
    std::printf("seed %llu, %d pairs each: P(p <= x) / x of %s\n", static_cast<unsigned long long>(test::seed + 7),
                pairs, of_what);
    struct Case {
        const char* name;
        Noise yours;
        int your_samples;
        Noise expected;
        int samples;
    };
    for (const Case& one :
         {Case{"exponential", exponential, 1, exponential, 1},
          Case{"exponential, 16", exponential, 16, exponential, 16}, Case{"fireflies", firefly, 4, firefly, 4},
          Case{"exponential for uniform", exponential, 2, uniform, 4},
          Case{"uniform for visible", uniform, 8, visible, 2}}) {
        std::vector<double> p;
        for (int i = 0; i < pairs; ++i) {
            const Estimates a = noisy_estimates(random, one.your_samples, one.yours);
            const Estimates b = noisy_estimates(random, one.samples, one.expected);
            for (const TileSums& sums : sums_of_pair(a, b, i))
                p.push_back(tile_probability(sums, deviation_of(sums, forgiven_floats)));
        }
        const auto count = static_cast<double>(p.size());
        std::printf("  %-24s", one.name);
        for (const double x : {0.3, 0.1, 0.01, 1e-3}) {
            const auto found = static_cast<double>(std::ranges::count_if(p, [=](double v) { return v <= x; }));
            std::printf("  %g: %.2f", x, found / count / x);
            EXPECT_LE(found, count * x * most + 3.3 * std::sqrt(count * x)) << one.name << " " << x;
        }
        std::printf("\n");
    }
}

}
