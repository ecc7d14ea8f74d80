#include <umbral/raytracing/shadows.hpp>

namespace umbral::raytracing {

bool sees_light(const ShadedPoint& point, const glm::vec4& light, const ShadowCasters& casters)
{
    // TODO: no light reaches a surface that is turned away from it. Otherwise make a ray from the point towards the
    // light, whose interval ends at a light that is at a place, and ask meets_any(casters, ray). The point is rounded:
    // how does the ray keep off the surface that it starts from?
    return not_implemented<bool>(point, light, casters);
}

}
