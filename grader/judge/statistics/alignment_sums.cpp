#include <cmath>

#include "judge/statistics/stochastic.hpp"

// Whether a noisy picture lies beside its place.
namespace umbral::grader {
namespace {

/// Sobel's slope of the mean of two pictures at the cell `at`, whose own value does not count.
double slope_at(const Estimates& a, const Estimates& b, std::size_t at, std::size_t along, std::size_t across)
{
    const auto mean = [&](std::size_t i) { return (a.values[i] + b.values[i]) / 2; };
    const auto side = [&](std::size_t i) { return mean(i - across) + 2 * mean(i) + mean(i + across); };
    return (side(at + along) - side(at - along)) / 8;
}

}

AlignmentSums alignment_sums(const Estimates& yours, const Estimates& expected, int channel, bool vertical)
{
    AlignmentSums result;
    TileSums& sums = result.sums;
    const auto width = static_cast<std::size_t>(expected.width);
    const auto height = static_cast<std::size_t>(expected.height);
    if (width < 3 || height < 3) return result;
    const std::size_t along = vertical ? width : 1;
    const std::size_t across = vertical ? 1 : width;
    double slopes = 0;
    for (std::size_t y = 1; y + 1 < height; ++y)
        for (std::size_t x = 1; x + 1 < width; ++x) {
            const std::size_t at = static_cast<std::size_t>(channel) * width * height + y * width + x;
            const double slope = slope_at(yours, expected, at, along, across);
            const double size = std::abs(slope);
            const double difference = yours.values[at] - expected.values[at];
            const double weighted = difference * slope;
            slopes += size;
            sums.count += 1;
            sums.yours += std::abs(yours.values[at]) * size;
            sums.expected += std::abs(expected.values[at]) * size;
            sums.total += expected.values[at] * slope;
            sums.difference += weighted;
            sums.squares += weighted * weighted;
            sums.cubes += weighted * weighted * weighted;
            result.misplaced += std::copysign(1.0, slope) * (slope == 0 ? 0 : difference);
            if (expected.steps.empty()) continue;
            sums.steps += expected.steps[at] * size;
            sums.clipped += yours.values[at] >= 1 || expected.values[at] >= 1 ? size : 0;
        }
    result.misplaced = std::abs(result.misplaced);
    if (slopes <= 0) return result;
    const double scale = sums.count / slopes;
    for (double* sum : {&sums.yours, &sums.expected, &sums.total, &sums.difference, &sums.steps, &sums.clipped})
        *sum *= scale;
    sums.squares *= scale * scale;
    sums.cubes *= scale * scale * scale;
    return result;
}

bool lies_better_moved(const Estimates& yours, const Estimates& expected, int right, int down)
{
    const int width = expected.width;
    double better_by = 0;
    for (int channel = 0; channel < expected.channels; ++channel)
        for (int y = 1; y + 1 < expected.height; ++y)
            for (int x = 1; x + 1 < width; ++x) {
                const int at = (channel * expected.height + y) * width + x;
                const double target = expected.values[static_cast<std::size_t>(at)];
                const double here = yours.values[static_cast<std::size_t>(at)] - target;
                const double there = yours.values[static_cast<std::size_t>(at - down * width - right)] - target;
                better_by += here * here - there * there;
            }
    return better_by > 0;
}

}
