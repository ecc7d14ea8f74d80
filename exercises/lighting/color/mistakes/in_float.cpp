// mistake: computes everything in float
// credit: 88..97
// hint: Beside the borders between codes a power in float picks the wrong one, and a sum of many dim lamps loses them.
// Compute in double, and round once, at the end.
#include <umbral/lighting/color.hpp>

namespace umbral::lighting {
namespace {

float clamped(float value) { return value > 0 ? std::min(value, 1.0F) : 0; }

}

glm::vec3 add_lights(std::span<const Lamp> lamps)
{
    glm::vec3 sum(0);
    for (const Lamp& lamp : lamps) sum += lamp.amount * lamp.color;
    return sum;
}

float encode_srgb(float light)
{
    const float c = clamped(light);
    return c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1 / 2.4F) - 0.055F;
}

float decode_srgb(float value)
{
    const float c = clamped(value);
    return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
}

glm::u8vec3 to_pixel(const glm::vec3& light)
{
    const auto code = [](float channel) { return static_cast<std::uint8_t>(255 * encode_srgb(channel) + 0.5F); };
    return {code(light.r), code(light.g), code(light.b)};
}

glm::vec3 to_light(const glm::u8vec3& pixel)
{
    const auto light = [](std::uint8_t code) { return decode_srgb(static_cast<float>(code) / 255); };
    return {light(pixel.r), light(pixel.g), light(pixel.b)};
}

glm::u8vec3 mean_pixel(std::span<const glm::u8vec3> pixels)
{
    glm::vec3 sum(0);
    for (const glm::u8vec3& pixel : pixels) sum += to_light(pixel);
    return pixels.empty() ? glm::u8vec3(0) : to_pixel(sum / static_cast<float>(pixels.size()));
}

}
