// alternative: each corner is turned from the one before, in double
#include <cmath>
#include <numbers>
#include <umbral/pipeline/polygon.hpp>

namespace umbral::pipeline {

std::vector<glm::vec2> polygon_loop(std::uint32_t sides)
{
    if (sides < 3) return {};
    const double step = 2 * std::numbers::pi / sides;
    const glm::dmat2 turn(std::cos(step), std::sin(step), -std::sin(step), std::cos(step));
    std::vector<glm::vec2> corners(sides);
    glm::dvec2 place(1, 0);
    for (glm::vec2& corner : corners) {
        corner = glm::vec2(place);
        place = turn * place;
    }
    return corners;
}

std::vector<glm::vec2> polygon_segments(std::uint32_t sides)
{
    std::vector<glm::vec2> ends;
    for (const glm::vec2& corner : polygon_loop(sides)) {
        if (!ends.empty()) ends.push_back(corner);
        ends.push_back(corner);
    }
    if (!ends.empty()) ends.push_back(ends.front());
    return ends;
}

IndexedPolygon polygon_fan(std::uint32_t sides)
{
    IndexedPolygon result;
    if (sides < 3) return result;
    result.positions = polygon_loop(sides);
    result.positions.emplace_back(0);
    for (std::uint32_t i = sides - 1, next = 0; next < sides; i = next++) result.triangles.emplace_back(i, next, sides);
    for (std::uint32_t i = 0; i < sides; ++i) result.edges.emplace_back(sides, i);
    for (const glm::uvec3& triangle : result.triangles) result.edges.emplace_back(triangle.y, triangle.x);
    return result;
}

}
