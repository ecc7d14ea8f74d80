#pragma once

#include <cmath>

namespace umbral::grader {

/// What files and screens hold, 0..1, of an amount of light, 0..1. Based on: IEC 61966-2-1 (sRGB).
[[nodiscard]] inline double srgb_encoded(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

/// The amount of light of what files and screens hold. Its inverse up to 1e-7, as the standard rounds its numbers.
[[nodiscard]] inline double srgb_decoded(double code)
{
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

}
