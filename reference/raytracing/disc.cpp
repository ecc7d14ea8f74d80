// Based on: A. S. Glassner (editor). An Introduction to Ray Tracing. 1989, chapter 2, 3.1: ray and plane.

#include <umbral/raytracing/disc.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Disc& disc)
{
    // In double, where products of floats are exact, and with the centre as origin, where coordinates are small.
    const glm::dvec3 direction(ray.direction);
    const glm::dvec3 normal(disc.normal);
    const glm::dvec3 to_origin = glm::dvec3(ray.origin) - glm::dvec3(disc.centre);

    const double approach = dot(direction, normal);
    if (approach == 0) return std::nullopt;
    const double t = -dot(to_origin, normal) / approach;

    const glm::dvec3 from_centre = to_origin + t * direction;
    const double radius = disc.radius;
    if (!(dot(from_centre, from_centre) < radius * radius)) return std::nullopt;

    const auto rounded = static_cast<float>(t);
    if (!(ray.t_min < rounded && rounded < ray.t_max)) return std::nullopt;
    return rounded;
}

}
