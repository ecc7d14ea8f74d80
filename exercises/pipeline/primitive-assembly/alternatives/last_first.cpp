// alternative: lists from the last primitive to the first, triangles begun at another corner, segments from end to
// beginning
#include <algorithm>
#include <umbral/pipeline/assembly.hpp>

namespace umbral::pipeline {
namespace {

using Indices = std::vector<std::uint32_t>;

std::vector<Primitive> in_groups(std::span<const std::uint32_t> vertices, std::size_t size)
{
    std::vector<Primitive> groups;
    for (; vertices.size() >= size; vertices = vertices.subspan(size))
        groups.push_back({Indices(vertices.begin(), vertices.begin() + static_cast<long>(size)), vertices[size - 1]});
    return groups;
}

std::vector<Primitive> strip_of_segments(Indices vertices, bool closed)
{
    if (vertices.size() < (closed ? 3 : 2)) return {};
    if (closed) vertices.push_back(vertices[0]);
    std::vector<Primitive> segments;
    for (std::size_t i = 1; i < vertices.size(); ++i) segments.push_back({{vertices[i - 1], vertices[i]}, vertices[i]});
    return segments;
}

std::vector<Primitive> triangles_from_pairs(std::span<const std::uint32_t> vertices, bool fan)
{
    std::vector<Primitive> result;
    if (vertices.size() < 3) return result;
    std::uint32_t a = vertices[0];
    std::uint32_t b = vertices[1];
    for (const std::uint32_t c : vertices.subspan(2)) {
        result.push_back({{a, b, c}, c});
        // The next triangle stands on the edge that leads on: from a to c, or from c to b.
        if (fan || result.size() % 2 == 0)
            b = c;
        else
            a = c;
    }
    return result;
}

}

std::vector<Primitive> assemble(PrimitiveType type, std::span<const std::uint32_t> vertices)
{
    std::vector<Primitive> result;
    switch (type) {
        case PrimitiveType::points: return in_groups(vertices, 1);
        case PrimitiveType::lines: return in_groups(vertices, 2);
        case PrimitiveType::triangles: return in_groups(vertices, 3);
        case PrimitiveType::quads: return in_groups(vertices, 4);
        case PrimitiveType::line_strip: return strip_of_segments({vertices.begin(), vertices.end()}, false);
        case PrimitiveType::line_loop: return strip_of_segments({vertices.begin(), vertices.end()}, true);
        case PrimitiveType::triangle_strip: return triangles_from_pairs(vertices, false);
        case PrimitiveType::triangle_fan: return triangles_from_pairs(vertices, true);
        case PrimitiveType::quad_strip:
            for (; vertices.size() >= 4; vertices = vertices.subspan(2))
                result.push_back({{vertices[3], vertices[2], vertices[0], vertices[1]}, vertices[3]});
            return result;
        case PrimitiveType::polygon:
            if (vertices.size() > 2) result.push_back({{vertices.begin(), vertices.end()}, vertices.front()});
    }
    return result;
}

bool is_front_facing(std::span<const glm::vec2> corners)
{
    double twice_area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 a(corners[i]);
        const glm::dvec2 b(corners[(i + 1) % corners.size()]);
        twice_area += a.x * b.y - b.x * a.y;
    }
    return twice_area > 0;
}

DrawList draw_list(PrimitiveType type, std::span<const std::uint32_t> vertices, std::span<const glm::vec2> window,
                   Culling culling, PolygonMode mode)
{
    DrawList list;
    for (const Primitive& primitive : assemble(type, vertices)) {
        const Indices& c = primitive.corners;
        PolygonMode shape = mode;
        if (c.size() == 1) shape = PolygonMode::point;
        if (c.size() == 2 && c[0] != c[1]) list.segments.emplace_back(c[0], c[1]);
        if (c.size() == 2) continue;
        if (c.size() > 2 && culling != Culling::none) {
            std::vector<glm::vec2> places;
            for (const std::uint32_t vertex : c) places.push_back(window[vertex]);
            if (is_front_facing(places) == (culling == Culling::front)) continue;
        }
        if (shape == PolygonMode::point) list.points.insert(list.points.end(), c.begin(), c.end());
        for (std::size_t i = 0; shape == PolygonMode::line && i < c.size(); ++i)
            if (c[i] != c[(i + 1) % c.size()]) list.segments.emplace_back(c[i], c[(i + 1) % c.size()]);
        for (std::size_t i = 1; shape == PolygonMode::fill && i + 1 < c.size(); ++i)
            if (c[0] != c[i] && c[i] != c[i + 1] && c[0] != c[i + 1]) list.triangles.emplace_back(c[0], c[i], c[i + 1]);
    }
    for (glm::uvec3& t : list.triangles) t = {t.z, t.x, t.y};
    for (glm::uvec2& segment : list.segments) segment = {segment.y, segment.x};
    std::reverse(list.points.begin(), list.points.end());
    std::reverse(list.segments.begin(), list.segments.end());
    std::reverse(list.triangles.begin(), list.triangles.end());
    return list;
}

}
