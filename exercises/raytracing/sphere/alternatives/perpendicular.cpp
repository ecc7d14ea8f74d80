// alternative: geometry instead of algebra: the foot of the perpendicular from the centre, and half the chord to both
// sides of it
#include <cmath>
#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    const float speed = length(ray.direction);
    const glm::vec3 along = ray.direction / speed;
    const glm::vec3 to_centre = sphere.centre - ray.origin;
    const float foot = dot(to_centre, along);
    const glm::vec3 passing = to_centre - foot * along;

    const float half_chord_squared = sphere.radius * sphere.radius - dot(passing, passing);
    if (half_chord_squared < 0) return std::nullopt;
    const float half_chord = std::sqrt(half_chord_squared);
    for (const float t : {(foot - half_chord) / speed, (foot + half_chord) / speed})
        if (ray.t_min < t && t < ray.t_max) return t;
    return std::nullopt;
}

}
