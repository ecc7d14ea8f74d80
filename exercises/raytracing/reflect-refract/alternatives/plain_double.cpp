// alternative: the course's formulas in double
#include <cmath>
#include <umbral/raytracing/reflect_refract.hpp>

namespace umbral::raytracing {

glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n)
{
    const glm::dvec3 i = normalize(glm::dvec3(v));
    const glm::dvec3 normal = normalize(glm::dvec3(n));
    const glm::dvec3 r = 2.0 * dot(i, normal) * normal - i;
    return r;
}

std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float outside, float inside)
{
    const glm::dvec3 i = normalize(glm::dvec3(v));
    glm::dvec3 normal = normalize(glm::dvec3(n));
    double r = static_cast<double>(outside) / static_cast<double>(inside);
    if (dot(i, normal) < 0) {
        normal = -normal;
        r = 1 / r;
    }
    const double c = dot(i, normal);
    const double k = 1 - r * r * (1 - c * c);
    if (k < 0) return std::nullopt;
    const glm::dvec3 t = (r * c - std::sqrt(k)) * normal - r * i;
    return glm::vec3(t);
}

std::optional<float> critical_angle(float from, float into)
{
    if (into < from) return static_cast<float>(std::asin(static_cast<double>(into) / from));
    return std::nullopt;
}

}
