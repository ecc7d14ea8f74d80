#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/ray.hpp>

/// Signed distances F(p) = s min ‖p - q‖ over the points q of a body's surface, with s = -1 within the body and +1
/// outside: on the surface F is 0. Course: "signed distance function (SDF)".
namespace umbral::raytracing::sdf {

/// From a ball of this radius round the origin. Like all of these right to 1e-6 of the largest length that is given,
/// for coordinates and lengths that are 0 or between 1e-15 and 1e15.
[[nodiscard]] float ball_distance(const glm::vec3& p, float radius);

/// From the box from -half to half, whose components are at least 0.
[[nodiscard]] float box_distance(const glm::vec3& p, const glm::vec3& half);

/// From a ring round the y axis: all points nearer than `minor` to the circle of radius `major` in the plane y = 0;
/// major >= minor > 0.
[[nodiscard]] float torus_distance(const glm::vec3& p, float major, float minor);

/// From all points nearer than `radius` to the segment from a to b, which may be a point.
[[nodiscard]] float capsule_distance(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float radius);

/// From Menger's sponge of this level within the box from (-1, -1, -1) to (1, 1, 1), or less: outside the sponge it is
/// never more than the distance, and it is 0 on the surface. That is enough for sphere tracing.
///
/// Level 0 is the box, m = box_distance(p, (1, 1, 1)). Each further level k = 1, 2, … takes the grid of cubes that are
/// 2 / 3^(k-1) wide and fill the box (and all space beyond it), and cuts tunnels a third as wide through the middle of
/// each, along x, y and z: m = max(m, (1 - w) / 3^k), where u = 3^k (p - c), c is the middle of the cube in which p
/// lies, and w the second smallest of |u.x|, |u.y|, |u.z|. Level 0 to 6. Right to 1e-6, for p within 10.
[[nodiscard]] float menger_distance(const glm::vec3& p, int level);

/// What tells the distance from one body.
using DistanceFunction = std::function<float(const glm::vec3&)>;

/// When to stop.
struct TraceLimits {
    float tolerance = 1e-4F;  ///< > 0; a point this near to a surface, on either side, is on it
    int max_steps = 128;      ///< as many points are looked at, and no more
};

/// Where a ray meets a body.
struct TracedPoint {
    float t;               ///< in lengths of the ray's direction
    std::uint32_t object;  ///< its place in the list
};

/// The first point of the ray from t_min on that is on the surface of the union of these bodies, found by sphere
/// tracing: of d, the least of all distances at a point, |d| is how far one may go without passing a surface, whether
/// outside or inside.
///
/// The first point is the one of t_min. A point with |d| <= tolerance is the answer, with the object whose distance is
/// d, or the first such; if there are more points to look at, the next one lies |d| further. There is none at or
/// beyond t_max; of no bodies there is none. The direction need not be unit, but is not null. NaN does not occur.
/// Course: INTERSECCIONSDF(o, v, O_0, …, O_n-1).
[[nodiscard]] std::optional<TracedPoint> sphere_trace(const Ray& ray, std::span<const DistanceFunction> bodies,
                                                      const TraceLimits& limits);

}
