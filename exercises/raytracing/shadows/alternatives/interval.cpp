// alternative: leaves the point where it is, and begins the interval where the ray has left the surface's error
// behind
#include <cmath>
#include <limits>
#include <umbral/raytracing/shadows.hpp>

namespace umbral::raytracing {

bool sees_light(const ShadedPoint& point, const glm::vec4& light, const ShadowCasters& casters)
{
    Ray ray{point.position, glm::vec3(light)};
    if (light.w == 1) {
        ray.direction -= point.position;
        ray.t_max = 1;
    }
    const glm::vec3 n = point.normal;
    const float rise = dot(n, ray.direction);
    if (!(rise > 0)) return false;
    // How far the surface may be above the point along n, and the t at which the ray is as high.
    const float above = 2 * point.error * (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z));
    ray.t_min = above / rise;
    return !meets_any(casters, ray);
}

}
