#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>
#include <umbral/raytracing/triangle.hpp>
namespace umbral::raytracing {
std::optional<TriangleHit> intersect(const Ray& ray, const Triangle& t)
{
    glm::dvec2 b; double d = 0;
    // Both sides: GLM's takes one.
    for (const double s : {1.0, -1.0}) {
        const glm::dvec3 o(ray.origin), dir(ray.direction);
        const bool hit = s > 0 ? glm::intersectRayTriangle(o, dir, glm::dvec3(t.v0), glm::dvec3(t.v1), glm::dvec3(t.v2), b, d) : glm::intersectRayTriangle(o, dir, glm::dvec3(t.v0), glm::dvec3(t.v2), glm::dvec3(t.v1), b, d);
        if (!hit) continue;
        if (!(ray.t_min < d && d < ray.t_max)) return std::nullopt;
        return s > 0 ? TriangleHit{float(d), float(b.x), float(b.y)} : TriangleHit{float(d), float(b.y), float(b.x)};
    }
    return std::nullopt;
}
}
