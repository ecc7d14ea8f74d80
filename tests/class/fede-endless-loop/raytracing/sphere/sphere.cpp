#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    // Make the direction's length 1, counting the factor… which never ends if halving jumps over the interval.
    glm::vec3 d = ray.direction;
    if (!(length(d) > 0) || std::isinf(length(d))) return std::nullopt;
    float factor = 1;
    while (length(d) < 0.9F || length(d) > 1.1F) {
        const float step = length(d) > 1 ? 0.5F : 2.0F;
        d *= step;
        factor *= step;
    }
    const glm::vec3 oc = ray.origin - sphere.centre;
    const float a = dot(d, d);
    const float b = dot(oc, d);
    const float c = dot(oc, oc) - sphere.radius * sphere.radius;
    const float discriminant = b * b - a * c;
    if (discriminant < 0) return std::nullopt;
    for (const float t : {factor * (-b - std::sqrt(discriminant)) / a, factor * (-b + std::sqrt(discriminant)) / a})
        if (t > ray.t_min && t < ray.t_max) return t;
    return std::nullopt;
}

}
