// alternative: as the course puts it: first the point of the plane, then its coordinates a and b in the triangle, as
// shares of the triangle's area
#include <umbral/raytracing/triangle.hpp>

namespace umbral::raytracing {

std::optional<TriangleHit> intersect(const Ray& ray, const Triangle& triangle)
{
    const glm::dvec3 o(ray.origin);
    const glm::dvec3 d(ray.direction);
    const glm::dvec3 v0(triangle.v0);
    const glm::dvec3 v1(triangle.v1);
    const glm::dvec3 v2(triangle.v2);
    const glm::dvec3 n = cross(v1 - v0, v2 - v0);
    const double facing = dot(d, n);
    if (facing == 0) return std::nullopt;
    const double t = dot(v0 - o, n) / facing;
    if (!(ray.t_min < t && t < ray.t_max)) return std::nullopt;

    const glm::dvec3 p = o + t * d;
    const double a = dot(cross(p - v0, v2 - v0), n) / dot(n, n);
    const double b = dot(cross(v1 - v0, p - v0), n) / dot(n, n);
    if (a < 0 || b < 0 || a + b > 1) return std::nullopt;
    return TriangleHit{static_cast<float>(t), static_cast<float>(a), static_cast<float>(b)};
}

}
