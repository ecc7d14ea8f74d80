// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 2.1). 2006, section 2.6.1: what
// each type of primitive does with a table of vertices.

#include <cmath>
#include <numbers>
#include <umbral/pipeline/polygon.hpp>

namespace umbral::pipeline {

std::vector<glm::vec2> polygon_loop(std::uint32_t sides)
{
    std::vector<glm::vec2> corners;
    if (sides < 3) return corners;
    corners.reserve(sides);
    for (std::uint32_t i = 0; i < sides; ++i) {
        // Each angle anew, in double: errors neither add up from corner to corner nor show in a float.
        const double angle = 2 * std::numbers::pi * i / sides;
        corners.emplace_back(std::cos(angle), std::sin(angle));
    }
    return corners;
}

std::vector<glm::vec2> polygon_segments(std::uint32_t sides)
{
    const std::vector<glm::vec2> corners = polygon_loop(sides);
    std::vector<glm::vec2> ends;
    ends.reserve(2 * corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        ends.push_back(corners[i]);
        ends.push_back(corners[(i + 1) % corners.size()]);
    }
    return ends;
}

IndexedPolygon polygon_fan(std::uint32_t sides)
{
    IndexedPolygon polygon{polygon_loop(sides), {}, {}};
    if (polygon.positions.empty()) return polygon;
    const std::uint32_t centre = sides;
    polygon.positions.emplace_back(0, 0);
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        polygon.triangles.emplace_back(centre, i, next);
        polygon.edges.emplace_back(i, next);
        polygon.edges.emplace_back(centre, i);
    }
    return polygon;
}

}
