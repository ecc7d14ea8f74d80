#include <umbral/raytracing/reflect_refract.hpp>
#include <cmath>
namespace umbral::raytracing {
using R = glm::detail::compute_reflect<3, double, glm::defaultp, false>;
using T = glm::detail::compute_refract<3, double, glm::defaultp, false>;
glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n) { return glm::vec3(R::call(-glm::normalize(glm::dvec3(v)), glm::normalize(glm::dvec3(n)))); }
std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float o, float i) {
    glm::dvec3 m = glm::normalize(glm::dvec3(n)), w = glm::normalize(glm::dvec3(v)); double eta = double(o) / i; if (dot(m, w) < 0) { m = -m; eta = 1 / eta; }
    auto r = T::call(-w, m, eta); if (r == glm::dvec3(0)) return {}; return glm::vec3(r); }
std::optional<float> critical_angle(float, float) { return {}; }
}
