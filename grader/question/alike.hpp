#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace umbral::grader {

/// Of the size of what is compared: less is rounding.
inline constexpr double rounding = 1e-5;

/// The largest of them decides: beside it, the others may be rounding.
[[nodiscard]] inline double size_of(std::span<const double> numbers)
{
    double most = 0;
    for (const double number : numbers) most = std::max(most, std::abs(number));
    return most;
}

/// Are two numbers equal but for the rounding of numbers of this size? Never where it is not finite: to infinity, all
/// are near.
[[nodiscard]] inline bool alike(double a, double b, double size)
{
    return std::isfinite(size) && std::abs(a - b) <= rounding * size;
}

/// Are two rows equal but for the rounding of numbers as large as the largest of `b`?
[[nodiscard]] inline bool alike_rows(std::span<const double> a, std::span<const double> b)
{
    const double size = size_of(b);
    return std::ranges::equal(a, b, [size](double x, double y) { return alike(x, y, size); });
}

}
