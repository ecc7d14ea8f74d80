// alternative: the plane's equation n·p = n·c, and the distance between two points of the world, in double
#include <umbral/raytracing/disc.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Disc& disc)
{
    const glm::dvec3 o(ray.origin);
    const glm::dvec3 d(ray.direction);
    const glm::dvec3 c(disc.centre);
    const glm::dvec3 n(disc.normal);
    const double facing = dot(d, n);
    if (facing == 0) return std::nullopt;
    const double t = (dot(n, c) - dot(n, o)) / facing;
    if (!(t > ray.t_min && t < ray.t_max)) return std::nullopt;
    const glm::dvec3 p = o + t * d;
    if (!(distance(p, c) < disc.radius)) return std::nullopt;
    return static_cast<float>(t);
}

}
