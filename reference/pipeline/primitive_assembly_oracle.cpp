#include <array>
#include <umbral/pipeline/assembly.hpp>

#include "wide.hpp"

// The same by tables: how far it is from a primitive to the next one, and which vertices from there make it. Areas by
// the shoelace formula with 113 bits, where products and sums of floats of a window's size are exact; long double is as
// wide where the compiler has no __float128 (arm64).

namespace umbral::pipeline {
namespace {

struct Recipe {
    std::size_t step;
    std::vector<std::size_t> even;  ///< corners, counted from the primitive's first vertex
    std::vector<std::size_t> odd;
};

Recipe recipe_of(PrimitiveType type)
{
    switch (type) {
        case PrimitiveType::points: return {1, {0}, {0}};
        case PrimitiveType::lines: return {2, {0, 1}, {0, 1}};
        case PrimitiveType::line_strip:
        case PrimitiveType::line_loop: return {1, {0, 1}, {0, 1}};
        case PrimitiveType::triangles: return {3, {0, 1, 2}, {0, 1, 2}};
        case PrimitiveType::triangle_strip: return {1, {0, 1, 2}, {1, 0, 2}};
        case PrimitiveType::triangle_fan: return {1, {1, 2}, {1, 2}};
        case PrimitiveType::quads: return {4, {0, 1, 2, 3}, {0, 1, 2, 3}};
        case PrimitiveType::quad_strip: return {2, {0, 1, 3, 2}, {0, 1, 3, 2}};
        default: return {1, {}, {}};
    }
}

}

std::vector<Primitive> assemble(PrimitiveType type, std::span<const std::uint32_t> s)
{
    if (type == PrimitiveType::polygon)
        return s.size() < 3 ? std::vector<Primitive>{} : std::vector<Primitive>{{{s.begin(), s.end()}, s[0]}};
    if (type == PrimitiveType::line_loop && s.size() < 3) return {};
    std::vector<std::uint32_t> sequence(s.begin(), s.end());
    if (type == PrimitiveType::line_loop) sequence.push_back(s[0]);

    const Recipe recipe = recipe_of(type);
    std::size_t reach = 0;
    for (const std::size_t place : recipe.even) reach = std::max(reach, place + 1);
    std::vector<Primitive> result;
    for (std::size_t first = 0; first + reach <= sequence.size(); first += recipe.step) {
        Primitive primitive{{}, sequence[first + reach - 1]};
        if (type == PrimitiveType::triangle_fan) primitive.corners.push_back(sequence[0]);
        for (const std::size_t place : first / recipe.step % 2 == 0 ? recipe.even : recipe.odd)
            primitive.corners.push_back(sequence[first + place]);
        result.push_back(primitive);
    }
    return result;
}

bool is_front_facing(std::span<const glm::vec2> corners)
{
    Wide twice_area = 0;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++)
        twice_area += Wide(corners[j].x) * corners[i].y - Wide(corners[j].y) * corners[i].x;
    return twice_area > 0;
}

DrawList draw_list(PrimitiveType type, std::span<const std::uint32_t> vertices, std::span<const glm::vec2> window,
                   Culling culling, PolygonMode mode)
{
    DrawList list;
    for (const Primitive& primitive : assemble(type, vertices)) {
        const std::vector<std::uint32_t>& corners = primitive.corners;
        const bool face = corners.size() >= 3;
        std::vector<glm::vec2> places;
        for (const std::uint32_t corner : corners) places.push_back(window[corner]);
        const bool front = is_front_facing(places);
        if (face && ((culling == Culling::front && front) || (culling == Culling::back && !front))) continue;
        if (corners.size() == 1 || (face && mode == PolygonMode::point))
            list.points.insert(list.points.end(), corners.begin(), corners.end());
        if (corners.size() == 2 && corners[0] != corners[1]) list.segments.emplace_back(corners[0], corners[1]);
        if (face && mode == PolygonMode::line)
            for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++)
                if (corners[i] != corners[j]) list.segments.emplace_back(corners[j], corners[i]);
        if (face && mode == PolygonMode::fill)
            for (std::size_t i = 2; i < corners.size(); ++i) {
                const glm::uvec3 t(corners[0], corners[i - 1], corners[i]);
                if (t.x != t.y && t.y != t.z && t.z != t.x) list.triangles.push_back(t);
            }
    }
    return list;
}

}
