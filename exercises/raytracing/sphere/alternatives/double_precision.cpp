// alternative: the school formula in double: squares of floats are exact there
// knob: ray-sphere
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
    for (const double t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (ray.t_min < t && t < ray.t_max) return static_cast<float>(t);
    return std::nullopt;
}

}
