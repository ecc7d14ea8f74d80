#pragma once

#include <cmath>
#include <kit/drawing.hpp>
#include <numbers>
#include <umbral/record/ask.hpp>
#include <umbral/transforms/affinity.hpp>
#include <vector>

/// Transformations that are affine, nearly, or not at all.
namespace umbral::transforms {

/// The course's transformation of the plane that is not affine; z stays. Where x is a multiple of 1/4 the cosine is 1,
/// so that there it looks like an affine one.
inline glm::dvec3 course_wave(const glm::dvec3& p)
{
    return {4 * p.x - 1, 2 * p.y + (2 + std::cos((8 * p.x - 2) * std::numbers::pi)) / 4, p.z};
}

/// A cell of the picture's grid as twelve pairs: its corners and the middles between them along x, on two levels.
inline std::vector<PointPair> cell_pairs(glm::dvec2 low, double side)
{
    std::vector<PointPair> pairs;
    for (int i = 0; i < 12; ++i) {
        const glm::dvec3 p(low.x + 0.5 * side * (i % 3), low.y + side * (i / 3 % 2), side * (i / 6));
        pairs.push_back({glm::vec3(p), glm::vec3(course_wave(p))});
    }
    return pairs;
}

/// The wave that it makes of a rectangle, and in each cell the affine map that comes nearest: green where it comes near
/// enough.
inline Image draw_wave(Recorder& out)
{
    constexpr int columns = 32;
    constexpr int rows = 8;
    constexpr double side = 1.0 / columns;
    Drawing drawing(560, 320, {-1.15, 0.1}, {3.15, 1.4});
    const auto place = [](double x, double y) { return glm::dvec2(course_wave({x, y, 0})); };
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const glm::dvec2 low(i * side, j * side);
            const std::vector<PointPair> pairs = cell_pairs(low, side);
            const std::optional<glm::mat4> map = ask<affine_from_points>(out, pairs);
            if (!map) continue;
            const auto corner = [&](double x, double y) {
                const glm::vec4 q = *map * glm::vec4(low.x + side * x, low.y + side * y, 0, 1);
                return glm::dvec2(q.x, q.y);
            };
            const glm::vec3 color = ask<is_affine>(out, pairs, 0.04F) ? ink::green : ink::orange;
            const std::vector<glm::dvec2> flag = {corner(0.1, 0.1), corner(0.9, 0.1), corner(0.9, 0.9),
                                                  corner(0.1, 0.9)};
            drawing.area(flag, color, 0.35 + 0.5 * j / rows);
        }
    }
    for (int j = 0; j <= rows; j += rows)
        for (int i = 0; i < 4 * columns; ++i)
            drawing.line(place(i * side / 4, j * side), place((i + 1) * side / 4, j * side), ink::white, 1.6);
    return drawing.picture();
}

}
