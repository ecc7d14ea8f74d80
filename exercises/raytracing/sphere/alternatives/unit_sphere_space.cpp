// alternative: as the course puts it: the ray is moved to the space where the sphere is the unit sphere round the
// origin
#include <cmath>
#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {
namespace {

std::optional<float> intersect_unit_sphere(const glm::dvec3& origin, const glm::dvec3& direction, double t_min,
                                           double t_max)
{
    const double a = dot(direction, direction);
    const double half_b = dot(origin, direction);
    const double quarter_discriminant = half_b * half_b - a * (dot(origin, origin) - 1);
    if (quarter_discriminant < 0) return std::nullopt;
    const double near = (-half_b - std::sqrt(quarter_discriminant)) / a;
    const double far = (-half_b + std::sqrt(quarter_discriminant)) / a;
    if (near > t_min && near < t_max) return static_cast<float>(near);
    if (far > t_min && far < t_max) return static_cast<float>(far);
    return std::nullopt;
}

}

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    const double radius = sphere.radius;
    const glm::dvec3 origin = (glm::dvec3(ray.origin) - glm::dvec3(sphere.centre)) / radius;
    // The direction is scaled too and not normalised again, so t stays what it was.
    return intersect_unit_sphere(origin, glm::dvec3(ray.direction) / radius, ray.t_min, ray.t_max);
}

}
