#include <umbral/lighting/color.hpp>
#include <glm/gtc/color_space.hpp>
#include <cmath>
namespace umbral::lighting {
using E = glm::detail::compute_rgbToSrgb<3, double, glm::defaultp>;
using D = glm::detail::compute_srgbToRgb<3, double, glm::defaultp>;
static double c(double x) { return x > 0 ? (x < 1 ? x : 1) : 0; }
glm::vec3 add_lights(std::span<const Lamp>) { return glm::vec3(0); }
float encode_srgb(float l) { return float(E::call(glm::dvec3(c(l)), 1 / 2.4).x); }
float decode_srgb(float v) { return float(D::call(glm::dvec3(c(v)), 2.4).x); }
glm::u8vec3 to_pixel(const glm::vec3& l) { auto e = E::call(glm::dvec3(c(l.x), c(l.y), c(l.z)), 1 / 2.4); return glm::u8vec3(glm::round(e * 255.0)); }
glm::vec3 to_light(const glm::u8vec3& p) { return glm::vec3(D::call(glm::dvec3(p) / 255.0, 2.4)); }
glm::u8vec3 mean_pixel(std::span<const glm::u8vec3>) { return glm::u8vec3(0); }
}
