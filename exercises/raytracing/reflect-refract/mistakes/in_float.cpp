// mistake: computes in float
// credit: 80..95
// hint: Near the critical angle cos²(t) is a small difference, of which float keeps few digits, and its root fewer.
// Compute in double, and make the directions unit there.
#include <cmath>
#include <umbral/raytracing/reflect_refract.hpp>

namespace umbral::raytracing {

glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n)
{
    const glm::vec3 i = normalize(v);
    const glm::vec3 normal = normalize(n);
    return 2 * dot(i, normal) * normal - i;
}

std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float outside, float inside)
{
    const glm::vec3 i = normalize(v);
    glm::vec3 normal = normalize(n);
    float r = outside / inside;
    if (dot(i, normal) < 0) {
        normal = -normal;
        r = inside / outside;
    }
    const float c = dot(i, normal);
    const float k = 1 - r * r * (1 - c * c);
    if (k < 0) return std::nullopt;
    return (r * c - std::sqrt(k)) * normal - r * i;
}

std::optional<float> critical_angle(float from, float into)
{
    if (into >= from) return std::nullopt;
    return std::asin(into / from);
}

}
