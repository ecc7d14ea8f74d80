#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <span>
#include <umbral/core/not_implemented.hpp>

namespace umbral::lighting {

/// What one lamp contributes to the light at one place.
struct Lamp {
    glm::vec3 color{1};  ///< red, green and blue of its light, each at least 0 and without an upper bound
    float amount = 1;    ///< how much of it arrives, at least 0: what mixes is amount * color
};

/// The light of all lamps together: additive mixing, (0, 0, 0) without a lamp. It is not clamped: light has no upper
/// bound, only pictures have. Guarantee of the reference: each channel is within 0.501 ulp of the exact sum, for up to
/// 10⁶ lamps. Course: section C 1.6, "mezcla aditiva".
[[nodiscard]] glm::vec3 add_lights(std::span<const Lamp> lamps);

/// The sRGB curve (IEC 61966-2-1): from linear light to the value in [0, 1] that a picture stores. Light below 0 counts
/// as 0, above 1 as 1, and NaN as 0. Guarantee of the reference: within 0.501 ulp. Course: section C 1.6, "ternas RGB
/// reproducibles".
[[nodiscard]] float encode_srgb(float light);

/// Its inverse: the linear light that a stored value stands for. Values below 0 count as 0, above 1 as 1, and NaN as 0.
/// Guarantee of the reference: within 0.501 ulp.
[[nodiscard]] float decode_srgb(float value);

/// The pixel of linear light: each channel encoded, times 255, rounded to the nearest code. Guarantee of the reference:
/// the nearest code for every float.
[[nodiscard]] glm::u8vec3 to_pixel(const glm::vec3& light);

/// The linear light of a pixel: each code divided by 255, decoded. to_pixel(to_light(pixel)) is the pixel itself, for
/// all codes.
[[nodiscard]] glm::vec3 to_light(const glm::u8vec3& pixel);

/// The pixel that shows these pixels as one, as a picture is made smaller: the mean of their **light**. Black without a
/// pixel.
[[nodiscard]] glm::u8vec3 mean_pixel(std::span<const glm::u8vec3> pixels);

}
