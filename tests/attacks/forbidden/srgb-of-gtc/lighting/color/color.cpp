#include <glm/gtc/color_space.hpp>
#include <umbral/lighting/color.hpp>
namespace umbral::lighting {
glm::vec3 add_lights(std::span<const Lamp> lamps) { glm::dvec3 all(0); for (const Lamp& l : lamps) all += double(l.amount) * glm::dvec3(l.color); return glm::vec3(all); }
float encode_srgb(float light) { return std::isnan(light) ? 0 : float(glm::convertLinearToSRGB(glm::dvec3(light)).x); }
float decode_srgb(float value) { if (std::isnan(value)) return 0; return float(glm::convertSRGBToLinear(glm::dvec3(glm::clamp(value, 0.0f, 1.0f))).x); }
glm::u8vec3 to_pixel(const glm::vec3& light) { return glm::u8vec3(glm::round(255.0 * glm::convertLinearToSRGB(glm::dvec3(light)))); }
glm::vec3 to_light(const glm::u8vec3& pixel) { return glm::vec3(glm::convertSRGBToLinear(glm::dvec3(pixel) / 255.0)); }
glm::u8vec3 mean_pixel(std::span<const glm::u8vec3> pixels) { if (pixels.empty()) return glm::u8vec3(0); glm::dvec3 all(0); for (const auto& p : pixels) all += glm::dvec3(to_light(p)); return to_pixel(glm::vec3(all / double(pixels.size()))); }
}
