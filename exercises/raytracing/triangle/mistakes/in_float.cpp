// mistake: decides in float on which side of an edge the ray passes
// credit: 70..97
// hint: Two triangles that share an edge must agree on which side of it the ray passes. In float each rounds on its
// own, and some rays pass between them. Compute in double, or with the same numbers for both.
// knob: ray-triangle
#include <umbral/raytracing/triangle.hpp>

namespace umbral::raytracing {

std::optional<TriangleHit> intersect(const Ray& ray, const Triangle& triangle)
{
    const glm::vec3 d(ray.direction);
    const glm::vec3 e1 = triangle.v1 - triangle.v0;
    const glm::vec3 e2 = triangle.v2 - triangle.v0;
    const glm::vec3 p = cross(d, e2);
    const float det = dot(e1, p);
    if (det == 0) return std::nullopt;

    const glm::vec3 s = ray.origin - triangle.v0;
    const float a = dot(s, p) / det;
    if (!(a >= 0 && a <= 1)) return std::nullopt;
    const glm::vec3 q = cross(s, e1);
    const float b = dot(d, q) / det;
    if (!(b >= 0 && a + b <= 1)) return std::nullopt;
    const float t = dot(e2, q) / det;
    if (!(t > ray.t_min && t < ray.t_max)) return std::nullopt;
    return TriangleHit{t, a, b};
}

}
