#include <array>
#include <umbral/raytracing/cylinder_cone.hpp>
#include <utility>

#include "wide_vector.hpp"

// The school's formula with 113 bits, rounded to float once.

namespace umbral::raytracing {
namespace {

std::optional<float> solved(const Ray& ray, Wide a, Wide b, Wide c)
{
    std::array<Wide, 2> roots{};
    std::size_t count = 0;
    if (a == 0) {
        if (b != 0) roots[count++] = -c / b;
    } else {
        const Wide discriminant = b * b - 4 * a * c;
        if (!(discriminant >= 0)) return std::nullopt;
        const Wide root = square_root(discriminant);
        roots = {(-b - root) / (2 * a), (-b + root) / (2 * a)};
        if (a < 0) std::swap(roots[0], roots[1]);
        count = 2;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Wide y = Wide{ray.origin.y} + roots[i] * Wide{ray.direction.y};
        const auto t = static_cast<float>(roots[i]);
        if (y >= 0 && y <= 1 && ray.t_min < t && t < ray.t_max) return t;
    }
    return std::nullopt;
}

}

float unit_cylinder_field(const glm::vec3& p)
{
    const auto [x, y, z] = widened(p);
    return static_cast<float>(x * x + z * z - 1);
}

float unit_cone_field(const glm::vec3& p)
{
    const auto [x, y, z] = widened(p);
    return static_cast<float>(x * x + z * z - (1 - y) * (1 - y));
}

std::optional<float> intersect_unit_cylinder(const Ray& ray)
{
    const WideVector o = widened(ray.origin);
    const WideVector d = widened(ray.direction);
    return solved(ray, d.x * d.x + d.z * d.z, 2 * (o.x * d.x + o.z * d.z), o.x * o.x + o.z * o.z - 1);
}

std::optional<float> intersect_unit_cone(const Ray& ray)
{
    const WideVector o = widened(ray.origin);
    const WideVector d = widened(ray.direction);
    const Wide above = o.y - 1;
    return solved(ray, d.x * d.x + d.z * d.z - d.y * d.y, 2 * (o.x * d.x + o.z * d.z - above * d.y),
                  o.x * o.x + o.z * o.z - above * above);
}

}
