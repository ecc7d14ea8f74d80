#pragma once

#include <cmath>

namespace umbral::grader {

/// Of the size of what is compared: less is rounding.
inline constexpr double rounding = 1e-5;

/// Are two numbers equal but for the rounding of numbers of this size? Never where it is not finite: to infinity, all
/// are near.
[[nodiscard]] inline bool alike(double a, double b, double size)
{
    return std::isfinite(size) && std::abs(a - b) <= rounding * size;
}

}
