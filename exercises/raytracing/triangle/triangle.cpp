#include <umbral/raytracing/triangle.hpp>

namespace umbral::raytracing {

std::optional<TriangleHit> intersect(const Ray& ray, const Triangle& triangle)
{
    // TODO: solve origin + t * direction = v0 + a (v1 - v0) + b (v2 - v0) for t, a and b. Return them if a and b are
    // not negative, a + b is at most 1, and t lies strictly between ray.t_min and ray.t_max; or std::nullopt otherwise.
    return not_implemented<std::optional<TriangleHit>>(ray, triangle);
}

}
