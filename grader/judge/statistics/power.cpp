#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "judge/statistics/stochastic.hpp"

namespace umbral::grader {
namespace {

/// Estimates of 0 lie so many standard deviations off where means prove something. Right work by another estimator
/// (directions over the whole hemisphere, a small lamp) has 2.3 and more.
constexpr double least_power = 1;
/// A bias of this share of the light, or less, that is told from noise of so many standard deviations: whoever's work
/// shows that may scatter as it likes.
constexpr double told_bias = 0.1;
constexpr double told_deviations = 5;
/// Rare estimates that are far too bright may spoil this share of the tiles.
constexpr double most_spoiled = 1.0 / 8;
/// Of light that is nowhere negative, estimates by differences (control variates) may take this share of it away again.
constexpr double most_negative = 0.5;

/// The variance of the noise in a part of a channel, at most: half the mean square of the differences of neighbours,
/// along the axis where they differ less. What the picture shows adds to it at edges only. 0 where nothing has a
/// neighbour.
double noise_variance(const Estimates& estimates, int channel, const TilePlace& place)
{
    const auto width = static_cast<std::size_t>(estimates.width);
    const double* const plane = estimates.values.data() +
                                static_cast<std::size_t>(channel) * width * static_cast<std::size_t>(estimates.height);
    double least = std::numeric_limits<double>::infinity();
    for (const bool vertical : {false, true}) {
        const int right = place.right - (vertical ? 0 : 1);
        const int bottom = place.bottom - (vertical ? 1 : 0);
        double squares = 0;
        for (int y = place.top; y < bottom; ++y)
            for (int x = place.left; x < right; ++x) {
                const double* const at = plane + static_cast<std::size_t>(y) * width + x;
                const double difference = at[vertical ? estimates.width : 1] - at[0];
                squares += difference * difference;
            }
        const double count = static_cast<double>(right - place.left) * (bottom - place.top);
        if (count > 0) least = std::min(least, squares / (2 * count));
    }
    return std::isfinite(least) ? least : 0;
}

/// How many times as widely as the expected estimates yours scatter in a tile; 0 where that hides nothing, and nothing
/// where the expected ones prove nothing themselves.
std::optional<double> hiding_scatter(const TileSums& sums, double yours_variance, double expected_variance)
{
    const double of_expected = sums.expected / std::sqrt(2 * sums.count * expected_variance);
    if (!(sums.expected > 0) || of_expected < least_power) return std::nullopt;
    const double deviation = std::sqrt(sums.count * (yours_variance + expected_variance));
    if (told_deviations * deviation <= told_bias * sums.expected) return 0;
    return std::sqrt(yours_variance / expected_variance);
}

/// The scatter of all tiles of this size but a share of most_spoiled; nothing if the expected estimates prove nothing
/// in them.
std::optional<double> hiding_scatter(const Estimates& yours, const Estimates& expected, int channel,
                                     const Tiling& tiling)
{
    std::vector<double> scatters;
    for (std::size_t n = 0; n < tiling.sums.size(); ++n) {
        const TilePlace place = tiling.place(n);
        const TileSums& sums = tiling.sums[n];
        const double of_expected = noise_variance(expected, channel, place);
        // What scatters slowly, from row to row or column to column, differs little from its neighbours: of the
        // differences from the expected estimates, in which what the picture shows is gone, all of the variance counts.
        const double of_differences =
            std::max(0.0, sums.squares - sums.difference * sums.difference / sums.count) / sums.count;
        const double of_yours = std::max(noise_variance(yours, channel, place), of_differences - of_expected);
        if (const auto one = hiding_scatter(sums, of_yours, of_expected)) scatters.push_back(*one);
    }
    if (scatters.empty()) return std::nullopt;
    const auto spoiled = static_cast<std::size_t>(most_spoiled * static_cast<double>(scatters.size()));
    const auto widest = scatters.end() - 1 - static_cast<std::ptrdiff_t>(spoiled);
    std::ranges::nth_element(scatters, widest);
    return *widest;
}

/// What negative estimates take away of a channel that is nowhere negative, as a share of its light; 0 of another one.
double negative_share(const Estimates& yours, const Estimates& expected, int channel)
{
    const auto size = static_cast<std::size_t>(expected.width) * static_cast<std::size_t>(expected.height);
    const std::size_t first = static_cast<std::size_t>(channel) * size;
    double light = 0;
    double negative = 0;
    for (std::size_t i = first; i < first + size; ++i) {
        if (expected.values[i] < 0) return 0;
        light += expected.values[i];
        negative -= std::min(0.0, yours.values[i]);
    }
    return light > 0 ? negative / light : 0;
}

}

bool cancels_itself(const Estimates& yours, const Estimates& expected)
{
    for (int channel = 0; channel < expected.channels; ++channel)
        if (negative_share(yours, expected, channel) > most_negative) return true;
    return false;
}

double hiding_scatter(const Estimates& yours, const Estimates& expected)
{
    double widest = 0;
    for (int channel = 0; channel < expected.channels; ++channel)
        for (const Tiling& tiling : tilings_of(yours, expected, channel))
            if (const std::optional<double> scatter = hiding_scatter(yours, expected, channel, tiling)) {
                widest = std::max(widest, *scatter);
                break;
            }
    return widest;
}

}
