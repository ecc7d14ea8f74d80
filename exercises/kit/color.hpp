#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>

/// Colours: the sRGB curve, and the inks of diagrams.
namespace umbral {

/// The sRGB curve (IEC 61966-2-1): from light in [0, 1], clamped, to what pictures store.
inline double srgb_encoded(double linear)
{
    const double light = std::clamp(linear, 0.0, 1.0);
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}
inline glm::dvec3 srgb_encoded(const glm::dvec3& linear)
{
    return {srgb_encoded(linear.r), srgb_encoded(linear.g), srgb_encoded(linear.b)};
}

/// Its inverse: the light that a stored value in [0, 1] stands for.
inline double srgb_decoded(double encoded)
{
    const double value = std::clamp(encoded, 0.0, 1.0);
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
inline glm::dvec3 srgb_decoded(const glm::dvec3& encoded)
{
    return {srgb_decoded(encoded.r), srgb_decoded(encoded.g), srgb_decoded(encoded.b)};
}

/// The opaque pixel of a colour in linear light, rounded. Places that are not a number are black.
inline glm::u8vec4 pixel_of(const glm::dvec3& linear)
{
    glm::u8vec4 pixel(0, 0, 0, 255);
    for (int i = 0; i < 3; ++i)
        if (!std::isnan(linear[i])) pixel[i] = static_cast<std::uint8_t>(255 * srgb_encoded(linear[i]) + 0.5);
    return pixel;
}

/// Colours of diagrams, sRGB in [0, 1]: they go with the pages of the reports, and can be told apart by the
/// colour-blind.
namespace ink {
inline constexpr glm::vec3 night(0.055F, 0.06F, 0.09F);
inline constexpr glm::vec3 slate(0.20F, 0.23F, 0.31F);
inline constexpr glm::vec3 mist(0.55F, 0.60F, 0.70F);
inline constexpr glm::vec3 white(0.95F, 0.96F, 0.98F);
inline constexpr glm::vec3 blue(0.34F, 0.71F, 0.91F);
inline constexpr glm::vec3 orange(0.90F, 0.62F, 0.10F);
inline constexpr glm::vec3 green(0.15F, 0.75F, 0.55F);
inline constexpr glm::vec3 red(0.90F, 0.40F, 0.25F);
inline constexpr glm::vec3 pink(0.85F, 0.52F, 0.72F);
}

/// A colour of the rainbow: hue in turns, any number.
inline glm::vec3 rainbow(float hue, float saturation, float value)
{
    const glm::vec3 phase = glm::fract(glm::vec3(hue) + glm::vec3(0, 2.0F / 3, 1.0F / 3)) * 6.0F;
    return value * glm::mix(glm::vec3(1), glm::clamp(glm::abs(phase - 3.0F) - 1.0F, 0.0F, 1.0F), saturation);
}

}
