// mistake: forgets the interval (t_min, t_max)
// credit: 72..85
// hint: You also return points behind the origin. A line meets the sphere there; the ray, whose t lies in (t_min, t_max), does not.
#include <cmath>
#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    const glm::dvec3 d(ray.direction);
    const glm::dvec3 o = glm::dvec3(ray.origin) - glm::dvec3(sphere.centre);
    const double radius = sphere.radius;
    const double a = dot(d, d);
    const double b = 2 * dot(o, d);
    const double c = dot(o, o) - radius * radius;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    return static_cast<float>((-b - root) / (2 * a));
}

}
