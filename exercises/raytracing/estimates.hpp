#pragma once

#include <umbral/record/recorder.hpp>

#include "painted_solids.hpp"

/// What estimates promise beside their mean, whatever way they are made.
namespace umbral::raytracing {

/// The variance of `repeats` estimates from so many samples each, `estimate(samples, random)`.
template <class Estimate>
double variance(Estimate&& estimate, int samples, int repeats, Random& random)
{
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < repeats; ++i) {
        Random own = own_random(random);
        const double value = estimate(samples, own);
        sum += value;
        squares += value * value;
    }
    return (squares - sum * sum / repeats) / (repeats - 1);
}

/// Records two promises of a question whose answer depends on chance, each beside a case in which it does not hold, so
/// that no constant passes for an answer. Estimates are such that two of them are hardly ever equal, and have no long
/// tails.
///   "again"   is the estimate the same again: from the same random numbers, whatever was asked between, 1; from
///   others,
///             0
///   "spread"  is the variance at most a quarter of that of a sample: of the mean of 16 samples or more, 1; of another
///   sample,
///             0. That of a mean of 16 is a sixteenth where they are independent, less where they are stratified:
///             chance makes a right one fail less than once in 10^9 times.
template <class Estimate>
void record_estimate(Recorder& out, Random& random, Estimate&& estimate)
{
    constexpr int repeats = 100;
    for (int i = 0; i < 6; ++i) {
        Random first = own_random(random);
        Random again = first;
        const float once = estimate(3, first);
        Random other = own_random(random);
        // Another number of samples each time, so that what takes turns between calls is not always at the same turn.
        out.append("again", estimate(1 + i, other) == once ? 1.0F : 0.0F);
        out.append("again", estimate(3, again) == once ? 1.0F : 0.0F);
    }
    const double one = variance(estimate, 1, repeats, random);
    for (const int samples : {1, 16, 1, 64, 1, 36})
        out.append("spread", 4 * variance(estimate, samples, repeats, random) <= one ? 1.0F : 0.0F);
}

}
