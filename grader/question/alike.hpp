#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace umbral::grader {

/// Of the size of what is compared: less is rounding.
inline constexpr double rounding = 1e-5;
/// Of what two floats are: their difference is as good as a rounding of these.
inline constexpr double of_floats = 4e-7;

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

[[nodiscard]] inline double length_of(std::span<const double> v)
{
    return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0));
}

/// Is each component of `a` that of `b`, but for the rounding of vectors of their size?
[[nodiscard]] inline bool alike_vectors(std::span<const double> a, std::span<const double> b)
{
    const double size = std::max(length_of(a), length_of(b));
    return std::ranges::equal(a, b, [size](double x, double y) { return alike(x, y, size); });
}

}
