// alternative: Cramer's rule, as T. Möller and B. Trumbore wrote it, in double
// knob: ray-triangle
#include <umbral/raytracing/triangle.hpp>

namespace umbral::raytracing {

std::optional<TriangleHit> intersect(const Ray& ray, const Triangle& triangle)
{
    const glm::dvec3 d(ray.direction);
    const glm::dvec3 e1 = glm::dvec3(triangle.v1) - glm::dvec3(triangle.v0);
    const glm::dvec3 e2 = glm::dvec3(triangle.v2) - glm::dvec3(triangle.v0);
    const glm::dvec3 p = cross(d, e2);
    const double det = dot(e1, p);
    if (det == 0) return std::nullopt;

    const glm::dvec3 s = glm::dvec3(ray.origin) - glm::dvec3(triangle.v0);
    const double a = dot(s, p) / det;
    if (!(a >= 0 && a <= 1)) return std::nullopt;
    const glm::dvec3 q = cross(s, e1);
    const double b = dot(d, q) / det;
    if (!(b >= 0 && a + b <= 1)) return std::nullopt;
    const double t = dot(e2, q) / det;
    if (!(t > ray.t_min && t < ray.t_max)) return std::nullopt;
    return TriangleHit{static_cast<float>(t), static_cast<float>(a), static_cast<float>(b)};
}

}
