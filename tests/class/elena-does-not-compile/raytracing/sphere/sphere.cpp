#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    const glm::vec3 oc = ray.origin - sphere.center;
    const float b = dot(oc, ray.direction)
    const float c = dot(oc, oc) - sphere.radius * sphere.radius;
    return -b - std::sqrt(b * b - c);
}

}
