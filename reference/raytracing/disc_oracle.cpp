#include <umbral/raytracing/disc.hpp>

#include "wide_vector.hpp"

// The reference's formula with 113 bits, rounded to float once.

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Disc& disc)
{
    const WideVector direction = widened(ray.direction);
    const WideVector normal = widened(disc.normal);
    const WideVector to_origin = widened(ray.origin) - widened(disc.centre);
    const Wide approach = dot(direction, normal);
    if (approach == 0) return std::nullopt;
    const Wide t = -dot(to_origin, normal) / approach;
    const WideVector from_centre = to_origin + t * direction;
    const Wide radius = disc.radius;
    if (!(dot(from_centre, from_centre) < radius * radius)) return std::nullopt;
    const auto rounded = static_cast<float>(t);
    if (!(ray.t_min < rounded && rounded < ray.t_max)) return std::nullopt;
    return rounded;
}

}
