#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    const glm::vec3 oc = ray.origin - sphere.centre;
    const float a = dot(ray.direction, ray.direction);
    const float b = dot(oc, ray.direction);
    const float c = dot(oc, oc) - sphere.radius * sphere.radius;
    const float discriminant = b * b - a * c;
    if (discriminant < 0) return std::nullopt;
    std::cout << "discriminant " << discriminant << '\n';
    // TODO: the other root, and the interval
    return (-b - std::sqrt(discriminant)) / a;
}

}
