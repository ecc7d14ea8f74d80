// Based on: IEC 61966-2-1:1999 (sRGB); H. Grassmann. Zur Theorie der Farbenmischung. 1853 (light adds).

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <umbral/lighting/color.hpp>

namespace umbral::lighting {
namespace {

// 0 also for NaN, which is not greater than anything.
double clamped(double value) { return value > 0 ? std::min(value, 1.0) : 0; }

// A power of light, as brightness is felt; near black a straight line, where the power would be infinitely steep.
double encoded(double light) { return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055; }

double decoded(double value) { return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4); }

}

glm::vec3 add_lights(std::span<const Lamp> lamps)
{
    glm::dvec3 sum(0);
    for (const Lamp& lamp : lamps) sum += double{lamp.amount} * glm::dvec3(lamp.color);
    return glm::vec3(sum);
}

float encode_srgb(float light) { return static_cast<float>(encoded(clamped(light))); }

float decode_srgb(float value) { return static_cast<float>(decoded(clamped(value))); }

glm::u8vec3 to_pixel(const glm::vec3& light)
{
    const auto code = [](float channel) {
        return static_cast<std::uint8_t>(std::lround(255 * encoded(clamped(channel))));
    };
    return {code(light.r), code(light.g), code(light.b)};
}

glm::vec3 to_light(const glm::u8vec3& pixel)
{
    return {decoded(pixel.r / 255.0), decoded(pixel.g / 255.0), decoded(pixel.b / 255.0)};
}

glm::u8vec3 mean_pixel(std::span<const glm::u8vec3> pixels)
{
    if (pixels.empty()) return glm::u8vec3(0);
    glm::dvec3 sum(0);
    for (const glm::u8vec3& pixel : pixels) sum += glm::dvec3(to_light(pixel));
    return to_pixel(glm::vec3(sum / static_cast<double>(pixels.size())));
}

}
