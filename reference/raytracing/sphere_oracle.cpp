#include <umbral/raytracing/intersect.hpp>

#include "wide_vector.hpp"

// The school formula with 113 bits, rounded to float once.
// Products of floats are exact here, and so is the discriminant but for its last few of 113 bits.

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    const WideVector to_origin = widened(ray.origin) - widened(sphere.centre);
    const WideVector direction = widened(ray.direction);
    const Wide radius = sphere.radius;
    const Wide a = dot(direction, direction);
    const Wide half_b = dot(to_origin, direction);
    const Wide c = dot(to_origin, to_origin) - radius * radius;
    const Wide discriminant = half_b * half_b - a * c;
    if (!(a > 0) || !(discriminant >= 0)) return std::nullopt;

    const Wide root = square_root(discriminant);
    for (const Wide t : {(-half_b - root) / a, (-half_b + root) / a}) {
        // The number that is returned lies in the interval.
        const auto rounded = static_cast<float>(t);
        if (ray.t_min < rounded && rounded < ray.t_max) return rounded;
    }
    return std::nullopt;
}

}
