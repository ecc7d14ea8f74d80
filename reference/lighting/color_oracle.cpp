// The same curve with roots by Newton's method in 113 bits: x^(1/2.4) is the twelfth root of x^5, and x^2.4 the fifth
// root of x^12. Rounded once.

#include <umbral/lighting/color.hpp>

#include "wide.hpp"

namespace umbral::lighting {
namespace {

Wide power(Wide base, int exponent)
{
    Wide product = 1;
    for (int i = 0; i < exponent; ++i) product *= base;
    return product;
}

Wide root(Wide value, int degree)
{
    // One step doubles the right digits of the estimate, from 64.
    const Wide estimate = std::pow(static_cast<long double>(value), 1.0L / degree);
    return estimate - (estimate - value / power(estimate, degree - 1)) / degree;
}

// The standard's constants are decimal fractions: quotients of whole numbers, none of them rounded.
Wide encoded(float light)
{
    if (!(light > 0)) return 0;
    if (light >= 1) return 1;
    if (Wide{light} * 10'000'000 <= 31308) return Wide{light} * 1292 / 100;
    return (1055 * root(power(light, 5), 12) - 55) / 1000;
}

Wide decoded(Wide value)
{
    if (!(value > 0)) return 0;
    if (value >= 1) return 1;
    if (value * 100'000 <= 4045) return value * 100 / 1292;
    return root(power((value * 1000 + 55) / 1055, 12), 5);
}

std::uint8_t nearest_code(float light)
{
    return static_cast<std::uint8_t>(static_cast<int>(255 * encoded(light) + Wide{0.5}));
}

}

glm::vec3 add_lights(std::span<const Lamp> lamps)
{
    Wide sum[3] = {0, 0, 0};
    for (const Lamp& lamp : lamps)
        for (int i = 0; i < 3; ++i) sum[i] += Wide{lamp.amount} * Wide{lamp.color[i]};
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

float encode_srgb(float light) { return static_cast<float>(encoded(light)); }

float decode_srgb(float value) { return static_cast<float>(decoded(value)); }

glm::u8vec3 to_pixel(const glm::vec3& light)
{
    return {nearest_code(light.r), nearest_code(light.g), nearest_code(light.b)};
}

glm::vec3 to_light(const glm::u8vec3& pixel)
{
    const auto light = [](std::uint8_t code) { return static_cast<float>(decoded(static_cast<Wide>(code) / 255)); };
    return {light(pixel.r), light(pixel.g), light(pixel.b)};
}

glm::u8vec3 mean_pixel(std::span<const glm::u8vec3> pixels)
{
    glm::vec3 light(0);
    for (int i = 0; i < 3 && !pixels.empty(); ++i) {
        Wide sum = 0;
        for (const glm::u8vec3& pixel : pixels) sum += decoded(static_cast<Wide>(pixel[i]) / 255);
        light[i] = static_cast<float>(sum / static_cast<int>(pixels.size()));
    }
    return to_pixel(light);
}

}
