#include <umbral/lighting/color.hpp>

namespace umbral::lighting {

glm::vec3 add_lights(std::span<const Lamp> lamps)
{
    // TODO: the sum of amount * color over all lamps. Light has no upper bound: nothing is clamped here.
    return not_implemented<glm::vec3>(lamps);
}

float encode_srgb(float light)
{
    // TODO: bring the light into [0, 1]; NaN counts as 0. Then the curve: a straight line up to 0.0031308, and a power
    // from there on.
    return not_implemented<float>(light);
}

float decode_srgb(float value)
{
    // TODO: the same way back. The line ends at 0.04045 on this side.
    return not_implemented<float>(value);
}

glm::u8vec3 to_pixel(const glm::vec3& light)
{
    // TODO: encode each channel, and take the nearest of the codes 0 to 255.
    return not_implemented<glm::u8vec3>(light);
}

glm::vec3 to_light(const glm::u8vec3& pixel)
{
    // TODO: code / 255, decoded, for each channel.
    return not_implemented<glm::vec3>(pixel);
}

glm::u8vec3 mean_pixel(std::span<const glm::u8vec3> pixels)
{
    // TODO: what has a meaningful mean is the light of pixels, not their codes.
    return not_implemented<glm::u8vec3>(pixels);
}

}
