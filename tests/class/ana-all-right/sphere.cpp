#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {

// I complete the square: the point of the ray that is nearest to the centre, and half the chord on either side of it.
std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    const glm::dvec3 d(ray.direction);
    const glm::dvec3 from_centre = glm::dvec3(ray.origin) - glm::dvec3(sphere.centre);
    const double dd = dot(d, d);
    const double nearest_t = -dot(from_centre, d) / dd;
    const glm::dvec3 nearest = from_centre + nearest_t * d;
    const double r = sphere.radius;
    const double half_chord_squared = r * r - dot(nearest, nearest);
    if (half_chord_squared < 0) return std::nullopt;

    const double half = std::sqrt(half_chord_squared / dd);
    for (const double t : {nearest_t - half, nearest_t + half})
        if (t > ray.t_min && t < ray.t_max) return static_cast<float>(t);
    return std::nullopt;
}

}
