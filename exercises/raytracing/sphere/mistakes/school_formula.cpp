// mistake: subtracts two numbers of size |origin - centre|²
// credit: 75..85
// hint: From far away b² and 4ac agree in all their digits, so their difference is noise. Measure how far the ray
// passes the centre instead.
// knob: ray-sphere
#include <cmath>
#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    const glm::vec3 o = ray.origin - sphere.centre;
    const float a = dot(ray.direction, ray.direction);
    const float b = 2 * dot(o, ray.direction);
    const float c = dot(o, o) - sphere.radius * sphere.radius;
    const float discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return std::nullopt;
    const float root = std::sqrt(discriminant);
    for (const float t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (ray.t_min < t && t < ray.t_max) return t;
    return std::nullopt;
}

}
