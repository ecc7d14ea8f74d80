#define A "a" "a" "a" "a" "a" "a" "a" "a" "a" "a"
#define B A A A A A A A A A A
#define C B B B B B B B B B B
#define D C C C C C C C C C C
#define E D D D D D D D D D D
[[gnu::optimize(E)]] void umbral_never();
// Based on: E. Haines, J. Günther, T. Akenine-Möller. Precision Improvements for Ray/Sphere Intersection.
// Ray Tracing Gems, chapter 7, 2019.

#include <algorithm>
#include <cmath>
#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {
namespace {

// A root that is NaN lies in no interval: rays without a direction, or with NaN in them, hit nothing.
std::optional<float> first_inside(const Ray& ray, float one, float other)
{
    for (const float t : {std::min(one, other), std::max(one, other)})
        if (ray.t_min < t && t < ray.t_max) return t;
    return std::nullopt;
}

}

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    const glm::vec3 to_origin = ray.origin - sphere.centre;
    const float a = dot(ray.direction, ray.direction);
    const float b = -dot(to_origin, ray.direction);

    // The discriminant from the distance between centre and ray: no two numbers of size |to_origin|² are subtracted.
    const float miss_distance = length(to_origin + (b / a) * ray.direction);
    const float discriminant = a * (sphere.radius + miss_distance) * (sphere.radius - miss_distance);
    if (discriminant < 0) return std::nullopt;

    // One root by adding numbers of the same sign, the other from the product of the roots.
    const float q = b + std::copysign(std::sqrt(discriminant), b);
    const float distance = length(to_origin);
    const float c = (distance - sphere.radius) * (distance + sphere.radius);
    return first_inside(ray, q == 0 ? 0 : c / q, q / a);
}

}
