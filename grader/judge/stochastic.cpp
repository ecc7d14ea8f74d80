#include "judge/stochastic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace umbral::grader {
namespace {

constexpr std::array tile_sides = {16, 64};
/// Share of the light that may differ without being noise: what clipping at 255 takes from the noisier of two pictures.
constexpr double allowed_share = 0.005;

/// Light of a code value, and the step to the next one there. Based on: IEC 61966-2-1 (sRGB).
struct Decoding {
    std::array<double, 256> light{};
    std::array<double, 256> step{};
};

const Decoding& decoding()
{
    static const Decoding table = [] {
        Decoding made;
        for (std::size_t code = 0; code < 256; ++code) {
            const double value = static_cast<double>(code) / 255;
            made.light[code] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        }
        for (std::size_t code = 0; code < 256; ++code) {
            const std::size_t below = std::min<std::size_t>(code, 254);
            made.step[code] = made.light[below + 1] - made.light[below];
        }
        return made;
    }();
    return table;
}

/// Sums over a tile.
struct Sums {
    double count = 0;
    double yours = 0;
    double expected = 0;
    double difference = 0;
    double squares = 0;  ///< of differences
    double steps = 0;    ///< of rounding at the expected values
};

Sums sums_of(const Picture& yours, const Picture& expected, int channel, int left, int top, int right, int bottom)
{
    const Decoding& table = decoding();
    Sums sums;
    for (int y = top; y < bottom; ++y) {
        const std::uint8_t* a = yours.row(channel, y);
        const std::uint8_t* b = expected.row(channel, y);
        for (int x = left; x < right; ++x) {
            const double difference = table.light[a[x]] - table.light[b[x]];
            sums.yours += table.light[a[x]];
            sums.expected += table.light[b[x]];
            sums.difference += difference;
            sums.squares += difference * difference;
            sums.steps += table.step[b[x]];
        }
    }
    sums.count = static_cast<double>(right - left) * (bottom - top);
    return sums;
}

/// A value of Student's t with `freedom` degrees as a normal deviate of the same probability.
/// Based on: D. L. Wallace. Bounds on Normal Approximations to Student's and the Chi-Square Distributions. 1959.
double as_normal(double t, double freedom)
{
    const double size = std::sqrt(freedom * std::log1p(t * t / freedom)) * (8 * freedom + 1) / (8 * freedom + 3);
    return std::copysign(size, t);
}

/// How far a tile's mean lies off, in standard deviations of a normal distribution.
double deviation_of(const Sums& sums)
{
    if (sums.count < 2) return 0;
    const double mean = sums.difference / sums.count;
    const double step = sums.steps / sums.count;
    const double variance = std::max(0.0, (sums.squares - sums.difference * mean) / (sums.count - 1));
    // Rounding moves a mean by half a step at most, and with noise of s steps by no more than exp(-2 pi² s²) of that (the first term of the
    // Fourier series of the rounding error bounds it); each picture has its share of the variance.
    const double noise = variance / (2 * step * step);
    const double rounding = step * std::exp(-2 * std::numbers::pi * std::numbers::pi * noise);
    const double excess = std::abs(mean) - rounding - allowed_share * sums.expected / sums.count;
    if (excess <= 0) return 0;
    // Rounding has a variance of its own, a twelfth of a step squared in each picture: no tile is judged as if it had none.
    const double error = std::sqrt((variance + step * step / 6) / sums.count);
    return as_normal(std::copysign(excess, mean) / error, sums.count - 1);
}

/// Tiles of about `side` pixels that cover `size`: their number; the last are no smaller than the others by more than a pixel.
int tiles_of(int size, int side) { return std::max(1, size / side); }

/// Chance that the largest of `tests` independent normal deviates exceeds |z|; exact where that chance is tiny.
double probability_of(double z, std::size_t tests)
{
    const double one = std::erfc(std::abs(z) / std::numbers::sqrt2);
    return one >= 1 ? 1 : -std::expm1(static_cast<double>(tests) * std::log1p(-one));
}

}

std::string StochasticRule::message() const
{
    if (agree) return {};
    constexpr std::array channels = {"red", "green", "blue"};
    const double percent = expected > 0 ? 100 * (yours - expected) / expected : 0;
    const std::string amount = expected > 0 ? fmt::format("{:.3g} % too {}", std::abs(percent), percent > 0 ? "high" : "low") : std::string("too high");
    return fmt::format("The {} light is {} in the {} x {} pixels from ({}, {}): {:.1f} standard deviations, which noise does once in {:.2g} pictures",
                       channels[static_cast<std::size_t>(channel)], amount, width, height, x, y, std::abs(worst_z), 1 / std::max(probability, 1e-300));
}

StochasticRule apply_stochastic_rule(const Picture& yours, const Picture& expected)
{
    StochasticRule rule;
    const auto test = [&](int channel, int across, int down) {
        for (int j = 0; j < down; ++j)
            for (int i = 0; i < across; ++i) {
                const auto edge = [](int size, int count, int index) { return static_cast<int>(static_cast<std::int64_t>(size) * index / count); };
                const int left = edge(expected.width, across, i);
                const int right = edge(expected.width, across, i + 1);
                const int top = edge(expected.height, down, j);
                const int bottom = edge(expected.height, down, j + 1);
                const Sums sums = sums_of(yours, expected, channel, left, top, right, bottom);
                const double z = deviation_of(sums);
                ++rule.tests;
                if (std::abs(z) <= std::abs(rule.worst_z)) continue;
                rule.worst_z = z;
                rule.x = left, rule.y = top, rule.width = right - left, rule.height = bottom - top;
                rule.channel = channel;
                rule.yours = sums.yours / sums.count;
                rule.expected = sums.expected / sums.count;
            }
    };
    for (int channel = 0; channel < expected.colours(); ++channel) {
        for (const int side : tile_sides) test(channel, tiles_of(expected.width, side), tiles_of(expected.height, side));
        test(channel, 1, 1);
    }
    rule.probability = probability_of(rule.worst_z, rule.tests);
    rule.agree = rule.probability >= stochastic_alpha;
    return rule;
}

}
