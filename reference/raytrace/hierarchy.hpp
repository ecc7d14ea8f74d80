#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <umbral/core/ray.hpp>
#include <vector>

#include "raytrace/lanes.hpp"
#include "raytrace/large_pages.hpp"

/// The engine's rays among triangles: a tree of boxes, eight children a node, eight triangles a packet, tested
/// together. The textbook form of the same is raytracing/bounding-volumes, and of the intersection raytracing/triangle.
namespace umbral::raytrace {

/// Up to eight children. Boxes are stored coordinate by coordinate, low and high side by side; of a child that is not
/// there low is +infinity and high -infinity.
struct alignas(32) Node {
    std::array<FloatLanes, 6> bounds;             ///< low x, high x, low y, high y, low z, high z
    std::array<std::uint32_t, lane_count> child;  ///< place of a node, or leaf_bit | place of a packet
};
inline constexpr std::uint32_t leaf_bit = 0x80000000U;

/// Up to eight triangles, coordinate by coordinate. A place that is free holds a triangle of NaN, which nothing meets.
struct alignas(32) Packet {
    std::array<std::array<FloatLanes, 3>, 3> corner;  ///< [corner][axis]
    std::array<std::uint32_t, lane_count> triangle;   ///< place in the list of the maker
};

/// Corners of a triangle.
struct Corners {
    glm::vec3 a, b, c;
};

/// Where a ray meets a triangle: at (1 - u - v) a + u b + v c.
struct Hit {
    static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t triangle = nothing;  ///< place in the list that the hierarchy was made of
    float t = std::numeric_limits<float>::infinity();
    float u = 0;
    float v = 0;
};

/// Plain data: made by make_hierarchy, asked by first_hit and is_blocked, by any number of threads.
struct Hierarchy {
    std::vector<Node, LargePages<Node>> nodes;  ///< the first is the root
    std::vector<Packet, LargePages<Packet>> packets;

    [[nodiscard]] std::size_t bytes() const { return nodes.size() * sizeof(Node) + packets.size() * sizeof(Packet); }
};

/// A hierarchy of these triangles: at most 2^28 of them, all coordinates finite. Split where the surface area heuristic
/// is least among 16 bins of each axis; where all centres are equal, in halves. The same whatever the machine.
/// Throws std::invalid_argument if there are too many.
/// Based on: I. Wald. On fast Construction of SAH-based Bounding Volume Hierarchies. 2007; H. Dammertz, J. Hanika,
/// A. Keller. Shallow Bounding Volume Hierarchies for Fast SIMD Ray Tracing of Incoherent Rays. 2008.
[[nodiscard]] Hierarchy make_hierarchy(std::span<const Corners> triangles);

/// The hit of least t in (t_min, t_max); Hit::nothing if there is none. Both sides of triangles count. Watertight: a
/// ray that crosses an edge or a corner that triangles share meets one of them, whatever is rounded.
/// Based on: S. Woop, C. Benthin, I. Wald. Watertight Ray/Triangle Intersection. 2013.
[[nodiscard]] Hit first_hit(const Hierarchy& hierarchy, const Ray& ray);

/// Is there any hit with t in (t_min, t_max)?
[[nodiscard]] bool is_blocked(const Hierarchy& hierarchy, const Ray& ray);

/// first_hit and is_blocked by one set of instructions.
struct Traversal {
    const char* name;
    Hit (*first_hit)(const Hierarchy& hierarchy, const Ray& ray);
    bool (*is_blocked)(const Hierarchy& hierarchy, const Ray& ray);
};

/// All that this processor can run, the fastest one first. They give the same hits, to the bit.
[[nodiscard]] std::span<const Traversal> traversals();

}
