#include <umbral/raytracing/triangle.hpp>

#include "wide_vector.hpp"

// The three equations o + t d = v0 + a (v1 - v0) + b (v2 - v0) by Cramer's rule with 113 bits, rounded to float once.
// Based on: T. Möller, B. Trumbore. Fast, Minimum Storage Ray/Triangle Intersection. Journal of Graphics Tools 2(1),
// 1997.

namespace umbral::raytracing {

std::optional<TriangleHit> intersect(const Ray& ray, const Triangle& triangle)
{
    const WideVector direction = widened(ray.direction);
    const WideVector edge1 = widened(triangle.v1) - widened(triangle.v0);
    const WideVector edge2 = widened(triangle.v2) - widened(triangle.v0);
    const WideVector from_v0 = widened(ray.origin) - widened(triangle.v0);
    const WideVector across = cross(direction, edge2);
    Wide determinant = dot(edge1, across);
    if (determinant == 0) return std::nullopt;

    const WideVector turned = cross(from_v0, edge1);
    Wide a = dot(from_v0, across);
    Wide b = dot(direction, turned);
    Wide t = dot(edge2, turned);
    if (determinant < 0) {
        determinant = -determinant;
        a = -a;
        b = -b;
        t = -t;
    }
    if (!(a >= 0 && b >= 0 && a + b <= determinant)) return std::nullopt;
    const auto rounded = static_cast<float>(t / determinant);
    if (!(ray.t_min < rounded && rounded < ray.t_max)) return std::nullopt;
    return TriangleHit{rounded, static_cast<float>(a / determinant), static_cast<float>(b / determinant)};
}

}
