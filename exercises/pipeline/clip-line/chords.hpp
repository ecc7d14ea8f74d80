#pragma once

#include <cmath>
#include <kit/drawing.hpp>
#include <numbers>
#include <umbral/pipeline/clip_line.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

/// The goal picture of pipeline/clip-line: chords of a circle, each from a point to the one at twice its angle, and a
/// window that they are cut to.
namespace umbral::pipeline {

inline Image draw_chords(Recorder& out, Variation& vary)
{
    constexpr int count = 150;
    const ClipWindow window{vary.near(glm::vec2(-0.95F, -0.58F), 0.2F), vary.near(glm::vec2(0.62F, 0.52F), 0.2F)};
    const auto on_circle = [](int i) {
        const double turn = 2 * std::numbers::pi * i / count;
        return glm::vec2(1.32 * std::cos(turn), 1.02 * std::sin(turn));
    };
    Drawing drawing(560, 440, {-1.4, -1.1}, {1.4, 1.1});
    for (const float x : {window.low.x, window.high.x}) drawing.line({x, -2}, {x, 2}, ink::slate, 1);
    for (const float y : {window.low.y, window.high.y}) drawing.line({-2, y}, {2, y}, ink::slate, 1);
    for (int i = 1; i < count; ++i) drawing.line(on_circle(i), on_circle(2 * i), ink::slate, 1, 0.55);
    for (int i = 1; i < count; ++i) {
        const LineSegment chord{on_circle(i), on_circle(2 * i)};
        const unsigned code = ask<region_code>(out, window, chord.from);
        const glm::vec3 across = (code & 1) != 0 ? ink::blue : (code & 2) != 0 ? ink::orange : ink::white;
        const glm::vec3 color = (code & 4) != 0   ? glm::mix(across, ink::pink, 0.6F)
                                : (code & 8) != 0 ? glm::mix(across, ink::green, 0.6F)
                                                  : across;
        drawing.disc(chord.from, 2.5, color);
        const std::optional<LineSegment> inside = ask<clip_segment>(out, window, chord);
        if (!inside) continue;
        drawing.line(inside->from, inside->to, color, 1.5, 0.9);
        for (const glm::vec2& end : {inside->from, inside->to}) drawing.disc(end, 2.2, color);
    }
    const std::array<glm::dvec2, 4> corners = {
        glm::dvec2(window.low), {window.high.x, window.low.y}, glm::dvec2(window.high), {window.low.x, window.high.y}};
    drawing.outline(corners, ink::white, 2);
    return drawing.picture();
}

}
