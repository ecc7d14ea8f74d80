// alternative: lifts the point by six errors, and counts in world units along a unit direction
#include <limits>
#include <umbral/raytracing/shadows.hpp>

namespace umbral::raytracing {

bool sees_light(const ShadedPoint& point, const glm::vec4& light, const ShadowCasters& casters)
{
    const glm::vec3 start = point.position + 6 * point.error * point.normal;
    glm::vec3 l(light);
    float distance = std::numeric_limits<float>::infinity();
    if (light.w != 0) {
        l -= start;
        distance = length(l);
    }
    if (dot(point.normal, l) <= 0) return false;
    const glm::vec3 unit(normalize(glm::dvec3(l)));
    return !meets_any(casters, Ray{start, unit, 0, distance});
}

}
