// alternative: the volumes of the tetrahedra of the ray and each edge, which must have the same sign
#include <umbral/raytracing/triangle.hpp>

namespace umbral::raytracing {

std::optional<TriangleHit> intersect(const Ray& ray, const Triangle& triangle)
{
    const glm::dvec3 d(ray.direction);
    const glm::dvec3 p0 = glm::dvec3(triangle.v0) - glm::dvec3(ray.origin);
    const glm::dvec3 p1 = glm::dvec3(triangle.v1) - glm::dvec3(ray.origin);
    const glm::dvec3 p2 = glm::dvec3(triangle.v2) - glm::dvec3(ray.origin);
    double w0 = dot(d, cross(p1, p2));
    double w1 = dot(d, cross(p2, p0));
    double w2 = dot(d, cross(p0, p1));
    const bool inside = (w0 >= 0 && w1 >= 0 && w2 >= 0) || (w0 <= 0 && w1 <= 0 && w2 <= 0);
    const double sum = w0 + w1 + w2;
    if (!inside || sum == 0) return std::nullopt;
    const glm::dvec3 n = cross(p1 - p0, p2 - p0);
    const double t = dot(p0, n) / dot(d, n);
    if (!(t > ray.t_min) || !(t < ray.t_max)) return std::nullopt;
    return TriangleHit{static_cast<float>(t), static_cast<float>(w1 / sum), static_cast<float>(w2 / sum)};
}

}
