// alternative: vectors of GLM in double from end to end, both branches of the curve computed and one chosen
#include <numeric>
#include <umbral/lighting/color.hpp>

namespace umbral::lighting {
namespace {

// min and max of GLM keep their first argument where the second is NaN.
glm::dvec3 within(const glm::vec3& light)
{
    return glm::min(glm::dvec3(1), glm::max(glm::dvec3(0), glm::dvec3(light)));
}

glm::dvec3 encoded(const glm::dvec3& light)
{
    const glm::dvec3 power = 1.055 * glm::pow(light, glm::dvec3(1 / 2.4)) - 0.055;
    return glm::mix(power, 12.92 * light, glm::lessThanEqual(light, glm::dvec3(0.0031308)));
}

glm::dvec3 decoded(const glm::dvec3& value)
{
    const glm::dvec3 power = glm::pow((value + 0.055) / 1.055, glm::dvec3(2.4));
    return glm::mix(power, value / 12.92, glm::lessThanEqual(value, glm::dvec3(0.04045)));
}

}

glm::vec3 add_lights(std::span<const Lamp> lamps)
{
    return glm::vec3(std::accumulate(
        lamps.begin(), lamps.end(), glm::dvec3(0),
        [](const glm::dvec3& sum, const Lamp& lamp) { return sum + glm::dvec3(lamp.color) * double{lamp.amount}; }));
}

float encode_srgb(float light) { return static_cast<float>(encoded(within(glm::vec3(light))).x); }

float decode_srgb(float value) { return static_cast<float>(decoded(within(glm::vec3(value))).x); }

glm::u8vec3 to_pixel(const glm::vec3& light) { return glm::u8vec3(glm::round(255.0 * encoded(within(light)))); }

glm::vec3 to_light(const glm::u8vec3& pixel) { return glm::vec3(decoded(glm::dvec3(pixel) / 255.0)); }

glm::u8vec3 mean_pixel(std::span<const glm::u8vec3> pixels)
{
    if (pixels.size() == 0) return {0, 0, 0};
    glm::dvec3 sum(0);
    for (const glm::u8vec3& pixel : pixels) sum += decoded(glm::dvec3(pixel) / 255.0);
    return to_pixel(glm::vec3(sum / double(pixels.size())));
}

}
