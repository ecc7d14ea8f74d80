#include <umbral/raytracing/sphere_tracing.hpp>

namespace umbral::raytracing::sdf {

float ball_distance(const glm::vec3& p, float radius)
{
    // TODO: how far p is from the origin, less the radius.
    return not_implemented<float>(p, radius);
}

float box_distance(const glm::vec3& p, const glm::vec3& half)
{
    // TODO: how far |p| lies beyond half, in each coordinate. Outside only what is positive counts; inside the face
    // that is nearest.
    return not_implemented<float>(p, half);
}

float torus_distance(const glm::vec3& p, float major, float minor)
{
    // TODO: the distance from the circle, less minor. It follows from the distance to the axis, and the height.
    return not_implemented<float>(p, major, minor);
}

float capsule_distance(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float radius)
{
    // TODO: the distance from the nearest point of the segment, less the radius.
    return not_implemented<float>(p, a, b, radius);
}

float menger_distance(const glm::vec3& p, int level)
{
    // TODO: begin with the box; cut the tunnels of each level.
    return not_implemented<float>(p, level);
}

std::optional<TracedPoint> sphere_trace(const Ray& ray, std::span<const DistanceFunction> bodies,
                                        const TraceLimits& limits)
{
    // TODO: go along the ray by the least distance until it is within the tolerance, or there are no more steps.
    return not_implemented<std::optional<TracedPoint>>(ray, bodies, limits);
}

}
