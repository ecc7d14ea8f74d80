#pragma once

#include <cmath>
#include <concepts>
#include <glm/glm.hpp>
#include <limits>

namespace umbral {

// A judge counts what is not finite as wrong, whatever was expected: it is what computations come to that went wrong.
// A unit where infinity or NaN may be the right answer records these numbers for them. Reports show what they stand
// for.

inline constexpr float recorded_infinity =
    0x1.2d4c6ap+127F;                                    ///< stands for infinity, its negative for that of -infinity
inline constexpr float recorded_nan = 0x1.8badb0p+127F;  ///< stands for NaN

/// The number to record for any number: itself if it is finite. No finite number of a unit's may be one of the two.
template <std::floating_point Number>
[[nodiscard]] Number recordable(Number number)
{
    if (std::isnan(number)) return Number{recorded_nan};
    return std::isinf(number) ? std::copysign(Number{recorded_infinity}, number) : number;
}

template <glm::length_t Size, class Number, glm::qualifier Precision>
[[nodiscard]] glm::vec<Size, Number, Precision> recordable(glm::vec<Size, Number, Precision> vector)
{
    for (glm::length_t i = 0; i < Size; ++i) vector[i] = recordable(vector[i]);
    return vector;
}

/// The other way round: what a recorded number stands for.
[[nodiscard]] inline double recorded_number(double number)
{
    if (number == double{recorded_nan}) return std::numeric_limits<double>::quiet_NaN();
    return std::abs(number) == double{recorded_infinity}
               ? std::copysign(std::numeric_limits<double>::infinity(), number)
               : number;
}

}
