#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/ray.hpp>
#include <umbral/raytracing/triangle.hpp>
#include <vector>

namespace umbral::raytracing {

/// The points between two corners, faces and corners included. It may be flat. Where low exceeds high in a coordinate
/// there are no points.
struct BoundingBox {
    glm::vec3 low;
    glm::vec3 high;
};

/// The smallest box that holds all triangles: its coordinates are theirs, unchanged. Of no triangles, low is +infinity
/// and high -infinity in all coordinates. Course: "volumen englobante".
[[nodiscard]] BoundingBox bounding_box(std::span<const Triangle> triangles);

/// Does the ray, for a t in [t_min, t_max], meet the box? The direction need not be unit, and any of its components may
/// be +0 or -0; the origin may lie in the box, or on the plane of a face. Directions of length 0, and numbers that are
/// NaN, do not occur. Right whenever the ray passes the box's edges, or its ends the box's faces, by more than 1e-5 of
/// the origin's distance; and for every box that holds a point of the ray exactly. Course: "intersección rayo-V".
[[nodiscard]] bool meets_box(const Ray& ray, const BoundingBox& box);

/// The first triangle on a ray.
struct FirstTriangle {
    std::uint32_t index;  ///< in the list that the hierarchy was made from
    TriangleHit hit;      ///< what intersect(ray, triangle) returns
};

/// Triangles in a tree of bounding volumes. It does not change; any number of them live side by side.
class TriangleHierarchy {
public:
    virtual ~TriangleHierarchy() = default;

    /// Of all triangles that `intersect` (triangle.hpp) finds on the ray, the one of the least t; of several with that
    /// t the one of the least index. **No hit is lost**: the answer is that of a loop over all triangles, to the bit.
    /// Takes time in proportion to log n for rays that meet few of n triangles' surroundings, in meshes.
    /// Course: "indexación espacial".
    [[nodiscard]] virtual std::optional<FirstTriangle> first_hit(const Ray& ray) const = 0;
};

/// A hierarchy of these triangles, any number of them, none included. It keeps what it needs of the list, which may
/// change or vanish afterwards. Takes time in proportion to n log n or n (log n)², and ends whatever the triangles are:
/// without area, equal, around one centre, the largest a million times as large as the smallest. All their coordinates
/// are finite.
[[nodiscard]] std::unique_ptr<TriangleHierarchy> make_triangle_hierarchy(std::span<const Triangle> triangles);

}
