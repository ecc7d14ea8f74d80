// alternative: makes direction and normal unit first, and counts in lengths of the direction at the end
#include <umbral/raytracing/disc.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Disc& disc)
{
    const double speed = length(glm::dvec3(ray.direction));
    const double normal_length = length(glm::dvec3(disc.normal));
    if (!(speed > 0) || !(normal_length > 0)) return std::nullopt;
    const glm::dvec3 along = glm::dvec3(ray.direction) / speed;
    const glm::dvec3 up = glm::dvec3(disc.normal) / normal_length;

    const glm::dvec3 to_centre = glm::dvec3(disc.centre) - glm::dvec3(ray.origin);
    const double cosine = dot(along, up);
    if (cosine == 0) return std::nullopt;
    const double distance = dot(to_centre, up) / cosine;
    if (length(distance * along - to_centre) >= disc.radius) return std::nullopt;
    const double t = distance / speed;
    if (t <= ray.t_min || t >= ray.t_max || !(t == t) || !(ray.t_min < ray.t_max)) return std::nullopt;
    return static_cast<float>(t);
}

}
