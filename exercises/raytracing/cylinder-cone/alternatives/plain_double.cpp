// alternative: the school's formula in double, with the linear equation as a case of its own
#include <cmath>
#include <umbral/raytracing/cylinder_cone.hpp>

namespace umbral::raytracing {
namespace {

bool counts(const Ray& ray, double t)
{
    const double y = ray.origin.y + t * ray.direction.y;
    return t > ray.t_min && t < ray.t_max && y >= 0 && y <= 1;
}

std::optional<float> smallest(const Ray& ray, double a, double b, double c)
{
    if (a == 0) {
        if (b == 0) return std::nullopt;
        const double only = -c / b;
        if (!counts(ray, only)) return std::nullopt;
        return static_cast<float>(only);
    }
    const double inside = b * b - 4 * a * c;
    if (inside < 0) return std::nullopt;
    const double one = (-b - std::sqrt(inside)) / (2 * a);
    const double other = (-b + std::sqrt(inside)) / (2 * a);
    const double nearer = one < other ? one : other;
    const double farther = one < other ? other : one;
    if (counts(ray, nearer)) return static_cast<float>(nearer);
    if (counts(ray, farther)) return static_cast<float>(farther);
    return std::nullopt;
}

}

float unit_cylinder_field(const glm::vec3& p) { return p.x * p.x + p.z * p.z - 1; }

float unit_cone_field(const glm::vec3& p)
{
    const float radius = 1 - p.y;
    return p.x * p.x + p.z * p.z - radius * radius;
}

std::optional<float> intersect_unit_cylinder(const Ray& ray)
{
    const glm::dvec3 o(ray.origin);
    const glm::dvec3 d(ray.direction);
    const double a = d.x * d.x + d.z * d.z;
    const double b = 2 * (o.x * d.x + o.z * d.z);
    const double c = o.x * o.x + o.z * o.z - 1;
    return smallest(ray, a, b, c);
}

std::optional<float> intersect_unit_cone(const Ray& ray)
{
    const glm::dvec3 o(ray.origin);
    const glm::dvec3 d(ray.direction);
    const double r = 1 - o.y;
    const double a = d.x * d.x + d.z * d.z - d.y * d.y;
    const double b = 2 * (o.x * d.x + o.z * d.z + r * d.y);
    const double c = o.x * o.x + o.z * o.z - r * r;
    return smallest(ray, a, b, c);
}

}
