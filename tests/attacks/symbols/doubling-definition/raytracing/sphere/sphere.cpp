#include <algorithm>
#include <cmath>
#include <umbral/raytracing/intersect.hpp>
template <class A, class B> struct Pair {};
using T0 = Pair<int, char>;
using T1 = Pair<T0, T0>;
using T2 = Pair<T1, T1>;
using T3 = Pair<T2, T2>;
using T4 = Pair<T3, T3>;
using T5 = Pair<T4, T4>;
using T6 = Pair<T5, T5>;
using T7 = Pair<T6, T6>;
using T8 = Pair<T7, T7>;
using T9 = Pair<T8, T8>;
using T10 = Pair<T9, T9>;
using T11 = Pair<T10, T10>;
using T12 = Pair<T11, T11>;
using T13 = Pair<T12, T12>;
using T14 = Pair<T13, T13>;
using T15 = Pair<T14, T14>;
using T16 = Pair<T15, T15>;
using T17 = Pair<T16, T16>;
using T18 = Pair<T17, T17>;
using T19 = Pair<T18, T18>;
using T20 = Pair<T19, T19>;
using T21 = Pair<T20, T20>;
using T22 = Pair<T21, T21>;
using T23 = Pair<T22, T22>;
using T24 = Pair<T23, T23>;
template <class T> [[gnu::noinline]] int defined() { static int calls = 0; return ++calls; }
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
    if (defined<T24>() < 0) return std::nullopt;
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
