#include <algorithm>
#include <cmath>
#include <limits>

#include "judge/statistics/error_budget.hpp"
#include "judge/statistics/stochastic.hpp"

namespace umbral::grader {
namespace {

/// Values beyond this many expected means are cut: rare bright ones cannot carry the mean alone.
constexpr double cut_means = 4;
/// Share of the expected mean by which the mean of what is left may differ: other estimators of some samples a pixel
/// stay far below.
constexpr double cut_share = 0.5;
/// This much rarer than a false alarm of the test itself, so that both share its level.
constexpr double rarer = 0.01;

Estimates cut(const Estimates& estimates, std::size_t channel, double limit)
{
    const std::size_t size = static_cast<std::size_t>(estimates.width) * static_cast<std::size_t>(estimates.height);
    Estimates result{1, static_cast<int>(size), 1, false, {}, {}};
    result.values.reserve(size);
    for (std::size_t i = channel * size; i < (channel + 1) * size; ++i)
        result.values.push_back(std::min(std::abs(estimates.values[i]), limit));
    return result;
}

/// In any channel: do the means of the values' sizes, cut at so many expected means, differ by more than half, beyond
/// chance?
bool any_mean_far_off(const Estimates& yours, const Estimates& expected, double most_means)
{
    const std::size_t size = static_cast<std::size_t>(expected.width) * static_cast<std::size_t>(expected.height);
    for (std::size_t channel = 0; channel < static_cast<std::size_t>(expected.channels); ++channel) {
        double sum = 0;
        for (std::size_t i = channel * size; i < (channel + 1) * size; ++i) sum += std::abs(expected.values[i]);
        const double limit = most_means * sum / static_cast<double>(size);
        if (!(limit > 0)) continue;
        const TileSums sums =
            tilings_of(cut(yours, channel, limit), cut(expected, channel, limit), 0).front().sums.front();
        const double probability = tile_probability(sums, deviation_of(sums, {cut_share, 0}));
        if (sidak_probability(std::min(1.0, tail_factor * probability), expected.channels) < rarer * check_alpha())
            return true;
    }
    return false;
}

}

bool scatters_apart(const Estimates& yours, const Estimates& expected)
{
    return any_mean_far_off(yours, expected, cut_means);
}

bool is_far_off(const Estimates& yours, const Estimates& expected)
{
    return any_mean_far_off(yours, expected, std::numeric_limits<double>::infinity());
}

}
