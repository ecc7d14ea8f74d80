#include <algorithm>
#include <array>
#include <vector>

#include "judge/statistics/weighted_sums.hpp"

// Whether a noisy picture is softer or sharper than it should be.
namespace umbral::grader {
namespace {

struct Step {
    int right;
    int down;
};

/// Pixels of the other colour of the chessboard: those next to one, and a knight's move away.
constexpr std::array<Step, 4> near = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
constexpr std::array<Step, 8> around = {{{1, 2}, {2, 1}, {-1, 2}, {-2, 1}, {1, -2}, {2, -1}, {-1, -2}, {-2, -1}}};
constexpr int reach = 2;

/// What lies below this share of the light is rounding.
constexpr double least_bulge = 1e-5;

/// How much lighter it is next to a cell than farther off, in the mean of two pictures; 0 where that is rounding.
double bulge_at(const Estimates& a, const Estimates& b, int channel, int x, int y)
{
    const auto mean = [&](const auto& steps) {
        double sum = 0;
        for (const Step& step : steps) {
            const auto at = static_cast<std::size_t>((channel * a.height + y + step.down) * a.width + x + step.right);
            sum += a.values[at] + b.values[at];
        }
        return sum / static_cast<double>(2 * steps.size());
    };
    const double here = mean(near);
    const double bulge = here - mean(around);
    return std::abs(bulge) > least_bulge * std::abs(here) ? bulge : 0;
}

/// Both pictures in cells of 2 x 2 pixels. Where one of them is white, what was cut off is unknown: both get the mean
/// of the two there, so that they do not differ.
void halve(Estimates& a, Estimates& b)
{
    Estimates small_a{a.width / 2, a.height / 2, a.channels, true, {}, {}};
    Estimates small_b = small_a;
    for (int channel = 0; channel < a.channels; ++channel)
        for (int y = 0; y < small_a.height; ++y)
            for (int x = 0; x < small_a.width; ++x) {
                double in_a = 0;
                double in_b = 0;
                double steps = 0;
                bool white = false;
                for (const Step& step : {Step{0, 0}, Step{1, 0}, Step{0, 1}, Step{1, 1}}) {
                    const auto at = static_cast<std::size_t>((channel * a.height + 2 * y + step.down) * a.width +
                                                             2 * x + step.right);
                    in_a += a.values[at] / 4;
                    in_b += b.values[at] / 4;
                    if (b.steps.empty()) continue;
                    steps += b.steps[at] / 4;
                    white = white || a.values[at] >= 1 || b.values[at] >= 1;
                }
                small_a.values.push_back(white ? (in_a + in_b) / 2 : in_a);
                small_b.values.push_back(white ? (in_a + in_b) / 2 : in_b);
                if (!b.steps.empty()) small_b.steps.push_back(steps);
            }
    a = std::move(small_a);
    b = std::move(small_b);
}

PatternSums sums_of_colour(const Estimates& yours, const Estimates& expected, int channel, int colour)
{
    WeightedSums sums(yours, expected);
    for (int y = reach; y + reach < expected.height; ++y)
        for (int x = reach + (reach + y + colour) % 2; x + reach < expected.width; x += 2)
            sums.add(static_cast<std::size_t>((channel * expected.height + y) * expected.width + x),
                     bulge_at(yours, expected, channel, x, y));
    return sums.result();
}

}

std::vector<PatternSums> sharpness_sums(Estimates yours, Estimates expected)
{
    constexpr std::array cells = {1, 2, 4};
    std::vector<PatternSums> all;
    for (const int cell : cells) {
        if (cell > 1) halve(yours, expected);
        for (int channel = 0; channel < expected.channels; ++channel)
            for (const int colour : {0, 1}) {
                all.push_back(sums_of_colour(yours, expected, channel, colour));
                all.back().misplaced *= cell * cell;
            }
    }
    return all;
}

}
