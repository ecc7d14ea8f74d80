#include "judge/statistics/weighted_sums.hpp"

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

PatternSums alignment_sums(const Estimates& yours, const Estimates& expected, int channel, bool vertical)
{
    WeightedSums sums(yours, expected);
    const auto width = static_cast<std::size_t>(expected.width);
    const auto height = static_cast<std::size_t>(expected.height);
    const std::size_t along = vertical ? width : 1;
    const std::size_t across = vertical ? 1 : width;
    for (std::size_t y = 1; y + 1 < height; ++y)
        for (std::size_t x = 1; x + 1 < width; ++x) {
            const std::size_t at = static_cast<std::size_t>(channel) * width * height + y * width + x;
            sums.add(at, slope_at(yours, expected, at, along, across));
        }
    return sums.result();
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
