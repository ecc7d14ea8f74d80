// alternative: turns the ray's half of the plane into a line: an interval of t for the heights, and one for the
// inside
#include <cmath>
#include <umbral/raytracing/cylinder_cone.hpp>

namespace umbral::raytracing {
namespace {

constexpr long double none = std::numeric_limits<long double>::quiet_NaN();

struct Places {
    long double first = none;
    long double second = none;
};

/// Where f(t) = a t² + 2 h t + c is 0, in long double, in their order.
Places zeros(long double a, long double h, long double c)
{
    Places places;
    if (a == 0) {
        places.first = -c / (2 * h);
        return places;
    }
    const long double root = std::sqrt(h * h - a * c);
    const long double q = h > 0 ? h + root : h - root;
    const long double t = -q / a;
    const long double u = q == 0 ? t : -c / q;
    places.first = std::fmin(t, u);
    places.second = std::fmax(t, u);
    if (std::isnan(root)) places = Places{};
    return places;
}

std::optional<float> nearest(const Ray& ray, const Places& places)
{
    auto admitted = [&ray](long double t) {
        if (std::isnan(t) || std::isinf(t)) return false;
        const long double y = ray.origin.y + t * ray.direction.y;
        const float answer = float(t);
        return !(y < 0 || y > 1) && !std::isnan(y) && ray.t_min < answer && answer < ray.t_max;
    };
    if (admitted(places.first)) return float(places.first);
    if (admitted(places.second)) return float(places.second);
    return {};
}

long double product(double a, double b, double c, double d)
{
    return static_cast<long double>(a) * b + static_cast<long double>(c) * d;
}

}

float unit_cylinder_field(const glm::vec3& p) { return float(product(p.x, p.x, p.z, p.z) - 1); }

float unit_cone_field(const glm::vec3& p)
{
    return float(product(p.x, p.x, p.z, p.z) - product(1.0 - p.y, 1.0 - p.y, 0, 0));
}

std::optional<float> intersect_unit_cylinder(const Ray& ray)
{
    const auto& [ox, oy, oz] = std::tuple(ray.origin.x, ray.origin.y, ray.origin.z);
    const auto& [dx, dy, dz] = std::tuple(ray.direction.x, ray.direction.y, ray.direction.z);
    if (dx == 0 && dz == 0) return {};
    return nearest(ray, zeros(product(dx, dx, dz, dz), product(ox, dx, oz, dz), product(ox, ox, oz, oz) - 1));
}

std::optional<float> intersect_unit_cone(const Ray& ray)
{
    const auto& [ox, oy, oz] = std::tuple(ray.origin.x, ray.origin.y, ray.origin.z);
    const auto& [dx, dy, dz] = std::tuple(ray.direction.x, ray.direction.y, ray.direction.z);
    const double below = 1.0 - oy;
    const long double a = product(dx, dx, dz, dz) - product(dy, dy, 0, 0);
    const long double h = product(ox, dx, oz, dz) + product(below, dy, 0, 0);
    const long double c = product(ox, ox, oz, oz) - product(below, below, 0, 0);
    if (a == 0 && h == 0) return {};
    return nearest(ray, zeros(a, h, c));
}

}
