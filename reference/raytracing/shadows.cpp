// Based on: M. Pharr, W. Jakob, G. Humphreys. Physically Based Rendering. 3rd edition, 2016, 3.9.5: robust spawned ray
// origins.

#include <cmath>
#include <limits>
#include <umbral/raytracing/shadows.hpp>

namespace umbral::raytracing {
namespace {

constexpr float endless = std::numeric_limits<float>::infinity();

/// A point that is above the surface whatever the rounding of `position` was, and a few errors from it.
glm::vec3 lifted(const ShadedPoint& point)
{
    // Errors of all three coordinates move a point along the normal by no more than this.
    const float lift = point.error * (std::abs(point.normal.x) + std::abs(point.normal.y) + std::abs(point.normal.z));
    glm::vec3 origin;
    for (int i = 0; i < 3; ++i) {
        const float offset = lift * point.normal[i];
        // The sum is rounded, too: one float further away it cannot have been rounded back.
        origin[i] = std::nextafter(point.position[i] + offset, std::copysign(endless, offset));
    }
    return origin;
}

}

bool sees_light(const ShadedPoint& point, const glm::vec4& light, const ShadowCasters& casters)
{
    const glm::dvec3 place(light);
    const bool is_directional = light.w == 0;
    const glm::dvec3 towards_light = is_directional ? place : place - glm::dvec3(point.position);
    if (!(dot(glm::dvec3(point.normal), towards_light) > 0)) return false;

    Ray ray;
    ray.origin = lifted(point);
    ray.direction = is_directional ? glm::vec3(light) : glm::vec3(light) - ray.origin;
    ray.t_max = is_directional ? endless : 1;
    return !meets_any(casters, ray);
}

}
