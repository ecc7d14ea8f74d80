#include "judge/statistics/stochastic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "judge/picture/srgb.hpp"
#include "judge/statistics/error_budget.hpp"

namespace umbral::grader {
namespace {

/// How far values of normal noise lie beyond its mean, on average, in standard deviations: sqrt(2 / pi). So much does
/// clipping there cut off from each value that it cuts, and less where it cuts less than half of them.
constexpr double mean_excess = 0.7979;

/// A tile's difference is no noise beyond this many standard deviations: all of it counts as misplaced.
constexpr double certain = 3;

/// Light of a code value, and the step to the next one there.
struct Decoding {
    std::array<double, 256> light{};
    std::array<double, 256> step{};
};

const Decoding& decoding()
{
    static const Decoding table = [] {
        Decoding made;
        for (std::size_t code = 0; code < 256; ++code) made.light[code] = srgb_decoded(static_cast<double>(code) / 255);
        for (std::size_t code = 0; code < 256; ++code) {
            const std::size_t below = std::min<std::size_t>(code, 254);
            made.step[code] = made.light[below + 1] - made.light[below];
        }
        return made;
    }();
    return table;
}

/// Cells times their variance: what noise alone makes of the sum of squares.
double noise_squares(const TileSums& sums)
{
    return std::max(0.0, sums.squares - sums.difference * sums.difference / sums.count);
}

/// Difference of the sums that need not be noise.
double forgiven_sum(const TileSums& sums, const Forgiven& forgiven)
{
    double sum = forgiven.relative * sums.expected + forgiven.absolute * sums.count;
    if (sums.steps > 0) {
        // Rounding moves a mean by half a step at most, and with noise of s steps by no more than exp(-2 pi² s²) of
        // that (the first term of the Fourier series of the rounding error bounds it); each picture has its share of
        // the variance.
        const double step = sums.steps / sums.count;
        const double variance = noise_squares(sums) / sums.count;
        sum += sums.steps * std::exp(-std::numbers::pi * std::numbers::pi * variance / (step * step));
        sum += sums.clipped * mean_excess * std::sqrt(variance);
    }
    return sum;
}

/// How much light of a tile lies in the wrong place, if noise cannot have put it there.
double misplaced_in(const TileSums& sums, const Forgiven& forgiven)
{
    const double excess = std::abs(sums.difference) - forgiven_sum(sums, forgiven);
    return excess > certain * std::sqrt(noise_squares(sums)) ? excess : 0;
}

}

double deviation_of(const TileSums& sums, const Forgiven& forgiven)
{
    const double excess = std::abs(sums.difference) - forgiven_sum(sums, forgiven);
    if (!(excess > 0)) return 0;
    // Rounding has a variance of its own, a twelfth of a step squared in each picture: no tile is judged as if it had
    // none.
    const double step = sums.steps / sums.count;
    return std::copysign(excess / std::sqrt(sums.squares + sums.count * step * step / 6), sums.difference);
}

double tile_probability(const TileSums& sums, double deviation)
{
    const double size = std::abs(deviation);
    const double symmetric = std::erfc(size / std::numbers::sqrt2);
    const double spread = noise_squares(sums);
    if (spread <= 0 || symmetric <= 0) return symmetric;
    const double mean = sums.difference / sums.count;
    const double third = sums.cubes - 3 * mean * sums.squares + 2 * sums.count * mean * mean * mean;
    // A self-normalised sum is smaller than normal on the side of the long tail, which then enlarges the root below it
    // too, and larger on the other. The term holds for moderate deviations only: beyond, half the exponent is left.
    const double skew = third / (spread * std::sqrt(spread)) * (deviation > 0 ? -1 : 1);
    const double heavier = std::min(skew * size * size * size / 3, size * size / 4);
    return heavier > 0 ? std::min(1.0, symmetric * std::exp(heavier)) : symmetric;
}

Estimates light_of(const Picture& picture)
{
    const Decoding& table = decoding();
    Estimates light{picture.width, picture.height, picture.colours(), true, {}, {}};
    const std::size_t count = static_cast<std::size_t>(light.channels) * static_cast<std::size_t>(light.width) *
                              static_cast<std::size_t>(light.height);
    light.values.reserve(count);
    light.steps.reserve(count);
    for (int channel = 0; channel < light.channels; ++channel)
        for (int y = 0; y < light.height; ++y)
            for (const std::uint8_t code : std::span(picture.row(channel, y), static_cast<std::size_t>(light.width))) {
                light.values.push_back(table.light[code]);
                light.steps.push_back(table.step[code]);
            }
    return light;
}

namespace {

/// "The red light is 12 % too high in the 16 x 16 pixels from (32, 16)"
std::string what_in_words(const StochasticRule& rule, const std::string& quantity)
{
    constexpr std::array colours = {"red ", "green ", "blue "};
    if (rule.worst == Worst::place)
        return fmt::format("{} too far {}", rule.by_pixels ? "The picture lies" : "Edges lie",
                           rule.right > 0   ? "to the right"
                           : rule.right < 0 ? "to the left"
                           : rule.down > 0  ? "down"
                                            : "up");
    if (rule.worst == Worst::sharpness)
        return fmt::format("The picture is too {}: edges, shadows or highlights are {} than they should be",
                           rule.worst_z > 0 ? "sharp" : "soft", rule.worst_z > 0 ? "harder" : "softer");
    const double percent = rule.expected != 0 ? 100 * (rule.yours - rule.expected) / std::abs(rule.expected) : 0;
    const std::string amount = rule.expected != 0
                                   ? fmt::format("{:.3g} % too {}", std::abs(percent), percent > 0 ? "high" : "low")
                                   : std::string("too high");
    if (rule.tiled)
        return fmt::format("The {}light is {} in the {} x {} pixels from ({}, {})",
                           rule.channels == 3 ? colours[static_cast<std::size_t>(rule.channel)] : "", amount,
                           rule.width, rule.height, rule.x, rule.y);
    return fmt::format("{} is {} on average over {} rows",
                       quantity.empty() ? fmt::format("Component {}", rule.channel) : quantity, amount, rule.height);
}

}

std::string StochasticRule::message(const std::string& quantity) const
{
    if (agree) return {};
    const std::string odds =
        probability > 1e-300 ? fmt::format("at most once in {:.2g}", 1 / probability) : std::string("never");
    return fmt::format("{}: {:.1f} standard deviations, which noise does {}{}", what_in_words(*this, quantity),
                       std::abs(worst_z), odds, probability > 1e-300 ? (tiled ? " pictures" : " tables") : "");
}

StochasticRule apply_stochastic_rule(const Estimates& yours, const Estimates& expected, const Forgiven& forgiven)
{
    StochasticRule rule;
    rule.channels = expected.channels;
    rule.tiled = expected.tiled;
    double smallest = 2;
    std::array<double, 3> wrong{};  // of the light, by size of the tiles
    std::array<double, 3> all{};
    double mean_share = 0;
    for (int channel = 0; channel < expected.channels; ++channel) {
        const std::vector<Tiling> tilings = tilings_of(yours, expected, channel);
        for (std::size_t level = 0; level < tilings.size(); ++level) {
            const Tiling& tiling = tilings[level];
            for (std::size_t n = 0; n < tiling.sums.size(); ++n) {
                const TileSums& sums = tiling.sums[n];
                const double z = deviation_of(sums, forgiven);
                const double probability = tile_probability(sums, z);
                const double misplaced = misplaced_in(sums, forgiven);
                const double light = std::max(sums.yours, sums.expected);
                wrong[level] += misplaced;
                all[level] += light;
                if (!rule.tiled && light > 0) mean_share += std::min(1.0, misplaced / light) / expected.channels;
                ++rule.tests;
                if (probability > smallest || (probability == smallest && std::abs(z) <= std::abs(rule.worst_z)))
                    continue;
                smallest = probability;
                const TilePlace place = tiling.place(n);
                rule.worst_z = z;
                rule.x = place.left, rule.width = place.right - place.left;
                rule.y = place.top, rule.height = place.bottom - place.top;
                rule.channel = channel;
                rule.expected = sums.total / sums.count;
                rule.yours = rule.expected + sums.difference / sums.count;
            }
        }
    }
    const double light = all.back() / expected.channels;
    const auto take = [&](const PatternSums& found, Worst what) {
        const double z = deviation_of(found.sums, forgiven);
        const double probability = tile_probability(found.sums, z);
        ++rule.tests;
        if (std::abs(z) > certain && light > 0)
            rule.misplaced = std::max(rule.misplaced, std::min(1.0, found.misplaced / light));
        if (!(probability < smallest)) return false;
        smallest = probability;
        rule.worst_z = z;
        rule.worst = what;
        return true;
    };
    for (int channel = 0; rule.tiled && channel < expected.channels; ++channel)
        for (const bool vertical : {false, true}) {
            if (!take(alignment_sums(yours, expected, channel, vertical), Worst::place)) continue;
            const int behind = rule.worst_z > 0 ? -1 : 1;
            rule.right = vertical ? 0 : behind;
            rule.down = vertical ? behind : 0;
        }
    if (rule.tiled)
        for (const PatternSums& found : sharpness_sums(yours, expected)) take(found, Worst::sharpness);
    rule.by_pixels = rule.worst == Worst::place && lies_better_moved(yours, expected, -rule.right, -rule.down);
    for (std::size_t level = 0; rule.tiled && level < wrong.size(); ++level)
        if (all[level] > 0) rule.misplaced = std::max(rule.misplaced, std::min(1.0, wrong[level] / all[level]));
    if (!rule.tiled) rule.misplaced = mean_share;
    rule.probability = sidak_probability(std::min(1.0, tail_factor * smallest), static_cast<double>(rule.tests));
    rule.agree = rule.probability >= stochastic_alpha;
    return rule;
}

StochasticRule apply_stochastic_rule(const Picture& yours, const Picture& expected)
{
    return apply_stochastic_rule(light_of(yours), light_of(expected), forgiven_bytes);
}

}
