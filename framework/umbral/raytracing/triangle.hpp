#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/ray.hpp>

namespace umbral::raytracing {

/// The points v0 + a (v1 - v0) + b (v2 - v0) with a, b >= 0 and a + b <= 1: edges and corners belong to it.
struct Triangle {
    glm::vec3 v0;
    glm::vec3 v1;
    glm::vec3 v2;
};

/// Where a ray meets a triangle: at origin + t * direction = v0 + a (v1 - v0) + b (v2 - v0). a and b are the
/// barycentric coordinates of v1 and v2; that of v0 is 1 - a - b.
struct TriangleHit {
    float t;
    float a;
    float b;
};

/// The point that the ray shares with the triangle, if there is one. A triangle has two sides: the ray may come from
/// either.
///
/// `ray.direction` need not be unit; the distance t is counted in its lengths, and lies in (t_min, t_max). It is
/// negative behind the origin, if t_min admits that.
/// Rays in the triangle's plane hit nothing, nor does any ray hit a triangle without area; rays without a direction, or
/// with NaN in them, hit nothing.
/// **Watertight**: of two triangles on both sides of an edge, every ray that crosses the edge hits at least one,
/// whatever is rounded; and through a corner, of all those around it.
/// Guarantee of the reference, down to sines of 1e-4 of the ray's angle with the plane: t is within 1 ulp, and a and
/// b within 1e-7, but of needles that are met at a slant. Course: problem 4.2.
[[nodiscard]] std::optional<TriangleHit> intersect(const Ray& ray, const Triangle& triangle);

}
