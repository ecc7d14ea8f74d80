// mistake: the school's formula in float
// credit: 70..95
// hint: From far away b² and 4ac agree in all the digits that float has, and near a = 0 so do -b and the root.
// Compute in double, where products of floats are exact.
#include <cmath>
#include <umbral/raytracing/cylinder_cone.hpp>

namespace umbral::raytracing {
namespace {

std::optional<float> smallest(const Ray& ray, float a, float b, float c)
{
    float one = -c / b;
    float other = one;
    if (a != 0) {
        const float inside = b * b - 4 * a * c;
        if (inside < 0) return std::nullopt;
        one = (-b - std::sqrt(inside)) / (2 * a);
        other = (-b + std::sqrt(inside)) / (2 * a);
        if (other < one) std::swap(one, other);
    }
    for (const float t : {one, other}) {
        const float y = ray.origin.y + t * ray.direction.y;
        if (t > ray.t_min && t < ray.t_max && y >= 0 && y <= 1) return t;
    }
    return std::nullopt;
}

}

float unit_cylinder_field(const glm::vec3& p) { return p.x * p.x + p.z * p.z - 1; }
float unit_cone_field(const glm::vec3& p) { return p.x * p.x + p.z * p.z - (1 - p.y) * (1 - p.y); }

std::optional<float> intersect_unit_cylinder(const Ray& ray)
{
    const auto& o = ray.origin;
    const auto& d = ray.direction;
    return smallest(ray, d.x * d.x + d.z * d.z, 2 * (o.x * d.x + o.z * d.z), o.x * o.x + o.z * o.z - 1);
}

std::optional<float> intersect_unit_cone(const Ray& ray)
{
    const auto& o = ray.origin;
    const auto& d = ray.direction;
    const float r = 1 - o.y;
    return smallest(ray, d.x * d.x + d.z * d.z - d.y * d.y, 2 * (o.x * d.x + o.z * d.z + r * d.y),
                    o.x * o.x + o.z * o.z - r * r);
}

}
