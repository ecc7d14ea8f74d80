#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>
#include <umbral/raytracing/intersect.hpp>
namespace umbral::raytracing {
std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    const double l = glm::length(glm::dvec3(ray.direction));
    const glm::dvec3 d = glm::dvec3(ray.direction) / l;
    glm::dvec3 place1, n1, place2, n2;
    if (!(l > 0) || !glm::intersectLineSphere(glm::dvec3(ray.origin), glm::dvec3(ray.origin) + d, glm::dvec3(sphere.centre), (double)sphere.radius, place1, n1, place2, n2)) return std::nullopt;
    const double a = glm::dot(place1 - glm::dvec3(ray.origin), d) / l, b = glm::dot(place2 - glm::dvec3(ray.origin), d) / l;
    for (double t : {std::min(a, b), std::max(a, b)}) if (t > ray.t_min && t < ray.t_max) return (float)t;
    return std::nullopt;
}
}
