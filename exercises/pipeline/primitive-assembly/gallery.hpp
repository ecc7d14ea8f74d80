#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <kit/drawing.hpp>
#include <umbral/pipeline/assembly.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

#include "sequences.hpp"

/// The goal picture of pipeline/primitive-assembly.
namespace umbral::pipeline {

inline glm::dvec3 hue(double turns)
{
    return 0.52 + 0.42 * glm::cos(6.283185307179586 * (turns + glm::dvec3(0, 0.66, 0.33)));
}

/// A triangle whose colours flow from corner to corner, in small pieces.
inline void draw_smooth(Drawing& drawing, const std::array<glm::dvec2, 3>& places,
                        const std::array<glm::dvec3, 3>& colors)
{
    constexpr int parts = 12;
    drawing.area(places, glm::vec3((colors[0] + colors[1] + colors[2]) / 3.0));
    const auto mixed = [](const auto& three, double i, double j) {
        return three[0] + i / parts * (three[1] - three[0]) + j / parts * (three[2] - three[0]);
    };
    for (int i = 0; i < parts; ++i)
        for (int j = 0; i + j < parts; ++j)
            for (const bool upper : {false, true}) {
                if (upper && i + j + 1 >= parts) continue;
                const std::vector<glm::dvec2> piece = {mixed(places, upper ? i + 1 : i, upper ? j + 1 : j),
                                                       mixed(places, i + 1, j), mixed(places, i, j + 1)};
                const double shift = upper ? 2.0 / 3 : 1.0 / 3;
                drawing.area(piece, glm::vec3(mixed(colors, i + shift, j + shift)));
            }
}

/// Rows: filled, lines, points. Columns: triangles, quads, polygon. One sequence of eight vertices in all nine.
inline Image gallery(Variation& vary, Recorder& out)
{
    const double hue_turn = vary.one_of(0.0, std::array{0.3, 0.5, 0.7});
    const float first_place = vary.one_of(0.5F, std::array{1.2F, 1.8F, 2.2F});  // in eighths of a turn
    constexpr std::uint32_t count = 8;
    Drawing drawing(480, 480, {-3.3, -3.3}, {3.3, 3.3});
    using enum PrimitiveType;
    const PrimitiveType columns[] = {triangles, quads, polygon};
    const PolygonMode rows[] = {PolygonMode::fill, PolygonMode::line, PolygonMode::point};
    std::vector<glm::vec2> window;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float angle = 6.2831853F * (static_cast<float>(i) + first_place) / static_cast<float>(count);
        window.push_back(240.0F + 80.0F * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    const auto color = [&](std::uint32_t vertex) { return hue(vertex / 8.0 + hue_turn); };
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const glm::dvec2 centre(2.2 * (column - 1), 2.2 * (1 - row));
            const auto place = [&](std::uint32_t vertex) {
                return vertex < count ? centre + (glm::dvec2(window[vertex]) - 240.0) / 85.0 : glm::dvec2(NAN);
            };
            for (std::uint32_t i = 0; i < count; ++i) drawing.ring(place(i), 4, ink::slate, 1.5);
            const DrawList list =
                sorted(ask<draw_list>(out, columns[column], counted(count), window, Culling::back, rows[row]));
            for (std::size_t i = 0; i < std::min<std::size_t>(list.triangles.size(), 12); ++i) {
                const glm::uvec3 t = list.triangles[i];
                draw_smooth(drawing, {place(t.x), place(t.y), place(t.z)}, {color(t.x), color(t.y), color(t.z)});
            }
            for (std::size_t i = 0; i < std::min<std::size_t>(list.segments.size(), 24); ++i) {
                const glm::uvec2 s = list.segments[i];
                for (int k = 0; k < 16; ++k)
                    drawing.line(glm::mix(place(s.x), place(s.y), k / 16.0),
                                 glm::mix(place(s.x), place(s.y), (k + 1) / 16.0),
                                 glm::vec3(glm::mix(color(s.x), color(s.y), (k + 0.5) / 16)), 4);
            }
            for (std::size_t i = 0; i < std::min<std::size_t>(list.points.size(), 24); ++i)
                drawing.disc(place(list.points[i]), 7, glm::vec3(color(list.points[i])));
        }
    return drawing.picture();
}

}
