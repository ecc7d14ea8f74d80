#include <algorithm>
#include <cmath>

#include "judge/noise/noise.hpp"
#include "judge/statistics/stochastic.hpp"

namespace umbral::grader {

Grid<std::uint8_t> noise_map(const Check& check, const Tensor& student, const Tensor& expected)
{
    const Estimates yours = estimates_of(check, student);
    const Estimates target = estimates_of(check, expected);
    const double levels = 255 / (expected.element == Element::uint8 ? 1 : check.range_high - check.range_low);
    Grid<std::uint8_t> map(target.width, target.height);
    for (int channel = 0; channel < target.channels; ++channel) {
        const Tiling small = tilings_of(yours, target, channel).front();
        for (std::size_t n = 0; n < small.sums.size(); ++n) {
            if (small.sums[n].squares == 0) continue;
            // A picture that is not finite differs by all there is.
            const double size = std::abs(small.sums[n].difference) / small.sums[n].count * levels;
            const auto level =
                static_cast<std::uint8_t>(std::isfinite(size) ? std::clamp(std::round(size), 1.0, 255.0) : 255.0);
            const std::size_t column = n % static_cast<std::size_t>(small.across);
            const std::size_t row = n / static_cast<std::size_t>(small.across);
            for (int y = small.top[row]; y < small.top[row + 1]; ++y)
                for (int x = small.left[column]; x < small.left[column + 1]; ++x)
                    map.at(x, y) = std::max(map.at(x, y), level);
        }
    }
    return map;
}

}
