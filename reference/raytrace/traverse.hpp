#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "raytrace/hierarchy.hpp"

/// The walk through a hierarchy, for files that are each compiled for other instructions. `Instructions` is a type of
/// that file alone, so that the linker cannot take one's code for the other's.
namespace umbral::raytrace {

/// A ray as boxes and triangles want it.
template <class Instructions>
struct PreparedRay {
    std::array<FloatLanes, 3> origin;
    std::array<FloatLanes, 3> inverse;  ///< of the direction
    std::array<int, 3> near;            ///< which of a box's six bounds the ray meets first, by axis
    int x, y, along;                    ///< axes: the last one is the longest of the direction
    FloatLanes shear_x, shear_y, shear_along;
};

/// Rays that run along a face's plane divide by this instead of by 0: large, and no NaN comes of it.
inline constexpr float least_slope = 1e-20F;

template <class Instructions>
void prepare(PreparedRay<Instructions>& to, const Ray& ray)
{
    for (int axis = 0; axis < 3; ++axis) {
        const float slope = ray.direction[axis];
        const float safe = std::abs(slope) < least_slope ? std::copysign(least_slope, slope) : slope;
        const auto place = static_cast<std::size_t>(axis);
        fill(to.origin[place], ray.origin[axis]);
        fill(to.inverse[place], 1 / safe);
        to.near[place] = 2 * axis + (std::signbit(safe) ? 1 : 0);
    }
    const glm::vec3 size = abs(ray.direction);
    to.along = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    to.x = (to.along + 1) % 3;
    to.y = (to.along + 2) % 3;
    fill(to.shear_x, ray.direction[to.x] / ray.direction[to.along]);
    fill(to.shear_y, ray.direction[to.y] / ray.direction[to.along]);
    fill(to.shear_along, 1 / ray.direction[to.along]);
}

/// Which children the ray may meet between `begin` and `end`, and where it enters them. What rounding takes from the
/// far side is given back: 1 + 6 half ulps. Based on: T. Ize. Robust BVH Ray Traversal. 2013.
template <class Instructions>
unsigned children_met(const PreparedRay<Instructions>& ray, const Node& node, float begin, float end, FloatLanes& entry)
{
    FloatLanes exit;
    fill(entry, begin);
    fill(exit, end);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto near = static_cast<std::size_t>(ray.near[axis]);
        const FloatLanes first = (node.bounds[near] - ray.origin[axis]) * ray.inverse[axis];
        const FloatLanes last = (node.bounds[near ^ 1U] - ray.origin[axis]) * ray.inverse[axis] * 1.0000004F;
        entry = first > entry ? first : entry;
        exit = last < exit ? last : exit;
    }
    return bits_of(entry <= exit);
}

/// Takes the nearest hit among the packet's triangles, if it is nearer than `hit`; of equal ones the first of the list.
template <class Instructions>
void meet_packet(const PreparedRay<Instructions>& ray, const Packet& packet, float begin, Hit& hit)
{
    std::array<FloatLanes, 3> x;
    std::array<FloatLanes, 3> y;
    std::array<FloatLanes, 3> z;
    const auto axis_x = static_cast<std::size_t>(ray.x);
    const auto axis_y = static_cast<std::size_t>(ray.y);
    const auto axis_z = static_cast<std::size_t>(ray.along);
    for (std::size_t i = 0; i < 3; ++i) {
        z[i] = packet.corner[i][axis_z] - ray.origin[axis_z];
        x[i] = packet.corner[i][axis_x] - ray.origin[axis_x] - ray.shear_x * z[i];
        y[i] = packet.corner[i][axis_y] - ray.origin[axis_y] - ray.shear_y * z[i];
    }
    // Products of the same numbers, so that both triangles of an edge see the ray on the same side of it.
    const FloatLanes a = x[2] * y[1] - y[2] * x[1];
    const FloatLanes b = x[0] * y[2] - y[0] * x[2];
    const FloatLanes c = x[1] * y[0] - y[1] * x[0];
    const IntLanes inside = ((a >= 0) & (b >= 0) & (c >= 0)) | ((a <= 0) & (b <= 0) & (c <= 0));
    if (bits_of(inside) == 0) return;
    const FloatLanes sum = a + b + c;
    const FloatLanes t = (a * z[0] + b * z[1] + c * z[2]) * ray.shear_along / sum;
    unsigned met = bits_of(inside & (sum != 0) & (t > begin) & (t <= hit.t));
    for (; met != 0; met &= met - 1) {
        const int lane = std::countr_zero(met);
        const std::uint32_t triangle = packet.triangle[static_cast<std::size_t>(lane)];
        if (t[lane] > hit.t || (t[lane] == hit.t && triangle >= hit.triangle)) continue;
        hit = {triangle, t[lane], b[lane] / sum[lane], c[lane] / sum[lane]};
    }
}

/// What is still to be looked at. A tree of 2^28 triangles is less than 64 levels deep, and each level leaves 7.
struct Waiting {
    std::uint32_t child;
    float entry;
};
inline constexpr std::size_t most_waiting = 64 * 7 + 8;

/// Has memory begin to fetch a child that will be looked at soon.
inline void prefetch(const Hierarchy& hierarchy, std::uint32_t child)
{
    constexpr std::size_t line = 64;
    const bool is_leaf = (child & leaf_bit) != 0;
    const auto* from = is_leaf ? reinterpret_cast<const char*>(&hierarchy.packets[child & ~leaf_bit])
                               : reinterpret_cast<const char*>(&hierarchy.nodes[child]);
    for (std::size_t i = 0; i < sizeof(Node); i += line) __builtin_prefetch(from + i);
}

/// Takes the nearest of the children that are met; the others go on the stack, the farthest first. (Where any hit will
/// do, the order is not worth the comparisons.)
template <bool first_found>
Waiting nearest_of(const Hierarchy& hierarchy, const Node& node, unsigned met, const FloatLanes& entry, Waiting* stack,
                   std::size_t& height)
{
    const auto next = [&] {
        const int lane = std::countr_zero(met);
        met &= met - 1;
        const std::uint32_t child = node.child[static_cast<std::size_t>(lane)];
        prefetch(hierarchy, child);
        return Waiting{child, entry[lane]};
    };
    const std::size_t bottom = height;
    Waiting nearest = next();
    while (met != 0) {
        Waiting one = next();
        std::size_t at = height++;
        if constexpr (!first_found) {
            if (one.entry < nearest.entry) std::swap(one, nearest);
            for (; at > bottom && stack[at - 1].entry < one.entry; --at) stack[at] = stack[at - 1];
        }
        stack[at] = one;
    }
    return nearest;
}

/// `first_found`: any hit will do.
template <class Instructions, bool first_found>
Hit walk(const Hierarchy& hierarchy, const Ray& ray)
{
    Hit hit;
    // Strictly before t_max, by a comparison that admits equality.
    hit.t = ray.t_max == std::numeric_limits<float>::infinity()
                ? std::numeric_limits<float>::max()
                : std::nextafter(ray.t_max, -std::numeric_limits<float>::infinity());
    if (hierarchy.nodes.empty() || ray.direction == glm::vec3(0)) return hit;
    PreparedRay<Instructions> prepared;
    prepare(prepared, ray);
    std::array<Waiting, most_waiting> stack;
    std::size_t height = 0;
    stack[height++] = {0, ray.t_min};
    while (height > 0) {
        Waiting now = stack[--height];
        if (now.entry > hit.t) continue;
        while ((now.child & leaf_bit) == 0) {
            const Node& node = hierarchy.nodes[now.child];
            FloatLanes entry;
            const unsigned met = children_met(prepared, node, ray.t_min, hit.t, entry);
            if (met == 0) break;
            now = nearest_of<first_found>(hierarchy, node, met, entry, stack.data(), height);
        }
        if ((now.child & leaf_bit) == 0) continue;
        meet_packet(prepared, hierarchy.packets[now.child & ~leaf_bit], ray.t_min, hit);
        if (first_found && hit.triangle != Hit::nothing) return hit;
    }
    return hit;
}

template <class Instructions>
constexpr Traversal traversal_by(const char* name)
{
    return {name, walk<Instructions, false>, [](const Hierarchy& hierarchy, const Ray& ray) {
                return walk<Instructions, true>(hierarchy, ray).triangle != Hit::nothing;
            }};
}

}
