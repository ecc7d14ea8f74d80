// mistake: computes in float, and takes the point in the world's coordinates
// credit: 80..95
// hint: Far from the world's origin p has no digits left for the distance to the centre, and along the disc d·n has
// few. Begin with o - c, and compute in double.
#include <umbral/raytracing/disc.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Disc& disc)
{
    const float facing = dot(ray.direction, disc.normal);
    if (facing == 0) return std::nullopt;
    const float t = dot(disc.centre - ray.origin, disc.normal) / facing;
    if (!(t > ray.t_min && t < ray.t_max)) return std::nullopt;
    const glm::vec3 p = ray.origin + t * ray.direction;
    if (!(distance(p, disc.centre) < disc.radius)) return std::nullopt;
    return t;
}

}
