// alternative: exponentials and logarithms in long double, each channel by a loop
#include <umbral/lighting/color.hpp>

namespace umbral::lighting {
namespace {

using Long = long double;

Long limited(Long value)
{
    if (std::isnan(value)) return 0;
    return std::clamp<Long>(value, 0, 1);
}

Long power(Long base, Long exponent) { return base == 0 ? 0 : std::exp(exponent * std::log(base)); }

Long curve(Long light)
{
    if (light < 0.0031308L) return light * 12.92L;
    return 1.055L * power(light, 5.0L / 12) - 0.055L;
}

Long curve_back(Long value)
{
    if (value < 0.04045L) return value / 12.92L;
    return power((value + 0.055L) / 1.055L, 12.0L / 5);
}

std::uint8_t code(Long light) { return static_cast<std::uint8_t>(std::floor(255 * curve(limited(light)) + 0.5L)); }

}

glm::vec3 add_lights(std::span<const Lamp> lamps)
{
    Long red = 0;
    Long green = 0;
    Long blue = 0;
    for (const auto& [color, amount] : lamps) {
        red += Long{amount} * color.r;
        green += Long{amount} * color.g;
        blue += Long{amount} * color.b;
    }
    return {red, green, blue};
}

float encode_srgb(float light) { return static_cast<float>(curve(limited(light))); }

float decode_srgb(float value) { return static_cast<float>(curve_back(limited(value))); }

glm::u8vec3 to_pixel(const glm::vec3& light) { return {code(light.r), code(light.g), code(light.b)}; }

glm::vec3 to_light(const glm::u8vec3& pixel)
{
    return {curve_back(pixel.r / 255.0L), curve_back(pixel.g / 255.0L), curve_back(pixel.b / 255.0L)};
}

glm::u8vec3 mean_pixel(std::span<const glm::u8vec3> pixels)
{
    // Each pixel is a lamp that shines with its share.
    std::vector<Lamp> lamps;
    for (const glm::u8vec3& pixel : pixels)
        lamps.push_back({to_light(pixel), 1.0F / static_cast<float>(pixels.size())});
    return to_pixel(add_lights(lamps));
}

}
