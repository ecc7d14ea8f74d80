#include <cmath>
#include <numbers>
#include <umbral/pipeline/polygon.hpp>

// Sine and cosine with at least 64 bits, of angles within an eighth of a turn: the rest is symmetry, which is exact.
// Rounded to float once.

namespace umbral::pipeline {
namespace {

glm::vec2 corner(std::uint64_t i, std::uint64_t sides)
{
    const std::uint64_t quarter = 4 * i / sides;
    const std::uint64_t rest = 4 * i % sides;  // in 1/(4 sides) of a turn, from where the quarter begins
    const bool second_half = 2 * rest > sides;
    const auto part = static_cast<long double>(second_half ? sides - rest : rest);
    const long double angle = std::numbers::pi_v<long double> / 2 * part / static_cast<long double>(sides);
    glm::vec<2, long double> place(std::cos(angle), std::sin(angle));
    if (second_half) std::swap(place.x, place.y);
    for (std::uint64_t turn = 0; turn < quarter; ++turn) place = {-place.y, place.x};
    return glm::vec2(place);
}

}

std::vector<glm::vec2> polygon_loop(std::uint32_t sides)
{
    std::vector<glm::vec2> corners;
    for (std::uint32_t i = 0; sides >= 3 && i < sides; ++i) corners.push_back(corner(i, sides));
    return corners;
}

std::vector<glm::vec2> polygon_segments(std::uint32_t sides)
{
    std::vector<glm::vec2> ends;
    for (std::uint32_t i = 0; sides >= 3 && i < 2 * sides; ++i) ends.push_back(corner((i + 1) / 2 % sides, sides));
    return ends;
}

IndexedPolygon polygon_fan(std::uint32_t sides)
{
    IndexedPolygon polygon{polygon_loop(sides), {}, {}};
    if (sides >= 3) polygon.positions.emplace_back(0, 0);
    for (std::uint32_t i = 0; sides >= 3 && i < sides; ++i) {
        polygon.triangles.emplace_back(i, (i + 1) % sides, sides);
        polygon.edges.insert(polygon.edges.end(), {{i, (i + 1) % sides}, {i, sides}});
    }
    return polygon;
}

}
