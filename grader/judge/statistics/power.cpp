#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "judge/statistics/stochastic.hpp"

namespace umbral::grader {
namespace {

/// Estimates of 0 lie so many standard deviations off where means prove something. Right work by another estimator
/// (directions over the whole hemisphere, a small lamp) has 2.3 and more.
constexpr double least_power = 1;
/// … and scatters up to 20 times as widely as the reference, in standard deviations.
constexpr double most_scatter = 30;
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

/// Of a tile: what its estimates can prove.
enum class Power { none_expected, enough, spoiled };

Power power_of(const TileSums& sums, double yours_variance, double expected_variance)
{
    const double of_expected = sums.expected / std::sqrt(2 * sums.count * expected_variance);
    if (!(sums.expected > 0) || of_expected < least_power) return Power::none_expected;
    const bool scatters = std::sqrt(yours_variance) > most_scatter * std::sqrt(expected_variance);
    return scatters && sums.expected < least_power * std::sqrt(sums.squares) ? Power::spoiled : Power::enough;
}

/// Nothing if the expected estimates prove nothing in tiles of this size.
std::optional<bool> lacks_power(const Estimates& yours, const Estimates& expected, int channel, const Tiling& tiling)
{
    std::size_t judged = 0;
    std::size_t spoiled = 0;
    for (std::size_t n = 0; n < tiling.sums.size(); ++n) {
        const TilePlace place = tiling.place(n);
        const Power power =
            power_of(tiling.sums[n], noise_variance(yours, channel, place), noise_variance(expected, channel, place));
        judged += power == Power::none_expected ? 0 : 1;
        spoiled += power == Power::spoiled ? 1 : 0;
    }
    if (judged == 0) return std::nullopt;
    return static_cast<double>(spoiled) > most_spoiled * static_cast<double>(judged);
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

bool lacks_power(const Estimates& yours, const Estimates& expected)
{
    for (int channel = 0; channel < expected.channels; ++channel)
        if (negative_share(yours, expected, channel) > most_negative) return true;

    for (int channel = 0; channel < expected.channels; ++channel)
        for (const Tiling& tiling : tilings_of(yours, expected, channel))
            if (const std::optional<bool> lacks = lacks_power(yours, expected, channel, tiling)) {
                if (*lacks) return true;
                break;
            }
    return false;
}

}
