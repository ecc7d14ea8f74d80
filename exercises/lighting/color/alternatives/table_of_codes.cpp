// alternative: a table of the light at the border between each two codes, searched; decoding a code by another table
#include <umbral/lighting/color.hpp>

namespace umbral::lighting {
namespace {

double decoded(double value) { return value > 0.04045 ? std::pow((value + 0.055) / 1.055, 2.4) : value / 12.92; }

struct Tables {
    std::array<float, 256> light{};
    std::array<double, 255> borders{};

    Tables()
    {
        for (int code = 0; code < 256; ++code) light[code] = static_cast<float>(decoded(code / 255.0));
        for (int code = 0; code < 255; ++code) borders[code] = decoded((code + 0.5) / 255.0);
    }
};

const Tables& tables()
{
    static const Tables all;
    return all;
}

}

glm::vec3 add_lights(std::span<const Lamp> lamps)
{
    // Neumaier's sum: what each addition loses is added at the end.
    glm::vec3 sum(0);
    glm::vec3 lost(0);
    for (const Lamp& lamp : lamps)
        for (int i = 0; i < 3; ++i) {
            const float term = lamp.amount * lamp.color[i];
            const float next = sum[i] + term;
            lost[i] += sum[i] >= term ? (sum[i] - next) + term : (term - next) + sum[i];
            sum[i] = next;
        }
    return sum + lost;
}

float encode_srgb(float light)
{
    if (!(light > 0)) return 0;
    if (light >= 1) return 1;
    return static_cast<float>(light < 0.0031308 ? light * 12.92 : std::pow(double{light}, 1 / 2.4) * 1.055 - 0.055);
}

float decode_srgb(float value)
{
    if (!(value > 0)) return 0;
    return value >= 1 ? 1.0F : static_cast<float>(decoded(value));
}

glm::u8vec3 to_pixel(const glm::vec3& light)
{
    const auto code = [](float channel) {
        if (std::isnan(channel)) return std::uint8_t{0};
        const auto& borders = tables().borders;
        return static_cast<std::uint8_t>(std::upper_bound(borders.begin(), borders.end(), channel) - borders.begin());
    };
    return {code(light.r), code(light.g), code(light.b)};
}

glm::vec3 to_light(const glm::u8vec3& pixel)
{
    const auto& light = tables().light;
    return {light[pixel.r], light[pixel.g], light[pixel.b]};
}

glm::u8vec3 mean_pixel(std::span<const glm::u8vec3> pixels)
{
    glm::vec3 mean(0);
    float count = 0;
    for (const glm::u8vec3& pixel : pixels) mean += (to_light(pixel) - mean) / ++count;
    return to_pixel(mean);
}

}
