// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 4.5, Compatibility Profile).
// 2017, sections 10.1 (types of primitives), 13.4 (flat shading) and 14.6.1 (the sign of a polygon's area).

#include <umbral/pipeline/assembly.hpp>

namespace umbral::pipeline {

std::vector<Primitive> assemble(PrimitiveType type, std::span<const std::uint32_t> s)
{
    std::vector<Primitive> result;
    const std::size_t n = s.size();
    const auto add = [&](std::vector<std::uint32_t> corners, std::uint32_t provoking) {
        result.push_back({std::move(corners), provoking});
    };
    switch (type) {
        case PrimitiveType::points:
            for (const std::uint32_t vertex : s) add({vertex}, vertex);
            break;
        case PrimitiveType::lines:
            for (std::size_t i = 0; i + 2 <= n; i += 2) add({s[i], s[i + 1]}, s[i + 1]);
            break;
        case PrimitiveType::line_strip:
            for (std::size_t i = 0; i + 2 <= n; ++i) add({s[i], s[i + 1]}, s[i + 1]);
            break;
        case PrimitiveType::line_loop:
            for (std::size_t i = 0; i < n && n >= 3; ++i) add({s[i], s[(i + 1) % n]}, s[(i + 1) % n]);
            break;
        case PrimitiveType::triangles:
            for (std::size_t i = 0; i + 3 <= n; i += 3) add({s[i], s[i + 1], s[i + 2]}, s[i + 2]);
            break;
        case PrimitiveType::triangle_strip:
            // Every other triangle would go round backwards: its first two corners change places.
            for (std::size_t i = 0; i + 3 <= n; ++i) add({s[i + i % 2], s[i + 1 - i % 2], s[i + 2]}, s[i + 2]);
            break;
        case PrimitiveType::triangle_fan:
            for (std::size_t i = 0; i + 3 <= n; ++i) add({s[0], s[i + 1], s[i + 2]}, s[i + 2]);
            break;
        case PrimitiveType::quads:
            for (std::size_t i = 0; i + 4 <= n; i += 4) add({s[i], s[i + 1], s[i + 2], s[i + 3]}, s[i + 3]);
            break;
        case PrimitiveType::quad_strip:
            for (std::size_t i = 0; i + 4 <= n; i += 2) add({s[i], s[i + 1], s[i + 3], s[i + 2]}, s[i + 3]);
            break;
        case PrimitiveType::polygon:
            if (n >= 3) add({s.begin(), s.end()}, s[0]);
            break;
    }
    return result;
}

bool is_front_facing(std::span<const glm::vec2> corners)
{
    // Triangles from the first corner. In double the differences of coordinates are exact, and so are the products of
    // those that are multiples of 1/1,024.
    double twice_area = 0;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const glm::dvec2 a = glm::dvec2(corners[i - 1]) - glm::dvec2(corners[0]);
        const glm::dvec2 b = glm::dvec2(corners[i]) - glm::dvec2(corners[0]);
        twice_area += a.x * b.y - a.y * b.x;
    }
    return twice_area > 0;
}

DrawList draw_list(PrimitiveType type, std::span<const std::uint32_t> vertices, std::span<const glm::vec2> window,
                   Culling culling, PolygonMode mode)
{
    DrawList list;
    const auto add_segment = [&](std::uint32_t a, std::uint32_t b) {
        if (a != b) list.segments.emplace_back(a, b);
    };
    for (const auto& [corners, provoking] : assemble(type, vertices)) {
        const std::size_t count = corners.size();
        if (count == 1) list.points.push_back(corners[0]);
        if (count == 2) add_segment(corners[0], corners[1]);
        if (count < 3) continue;

        std::vector<glm::vec2> places;
        for (const std::uint32_t corner : corners) places.push_back(window[corner]);
        if (culling == (is_front_facing(places) ? Culling::front : Culling::back)) continue;
        switch (mode) {
            case PolygonMode::point: list.points.insert(list.points.end(), corners.begin(), corners.end()); break;
            case PolygonMode::line:
                for (std::size_t i = 0; i < count; ++i) add_segment(corners[i], corners[(i + 1) % count]);
                break;
            case PolygonMode::fill:
                for (std::size_t i = 2; i < count; ++i)
                    if (corners[0] != corners[i - 1] && corners[i - 1] != corners[i] && corners[i] != corners[0])
                        list.triangles.emplace_back(corners[0], corners[i - 1], corners[i]);
        }
    }
    return list;
}

}
