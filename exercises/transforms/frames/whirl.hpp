#pragma once

#include <cmath>
#include <kit/drawing.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/frames.hpp>

/// A whirl of frames, each a little smaller and turned beside the last one, as someone sees it who stands in an oblique
/// frame.
namespace umbral::transforms {

inline Frame whirl_frame(int k)
{
    const float size = std::pow(0.966F, static_cast<float>(k));
    const float turn = 0.235F * static_cast<float>(k) - 1.3F;
    const glm::vec3 x = size * glm::vec3(std::cos(turn), std::sin(turn), 0);
    const glm::vec3 y(-x.y, x.x, 0);
    // Every fourth frame is left-handed.
    return {x, k % 4 == 3 ? -y : y, {0, 0, size}, 5.0F * x + glm::vec3(40, 30, 0)};
}

inline Image draw_whirl(Variation& vary, Recorder& out)
{
    constexpr int frames = 96;
    const Frame viewer{glm::vec3(vary.near(glm::vec2(1, 0.12F), 0.25F), 0),
                       glm::vec3(vary.near(glm::vec2(-0.2F, 1), 0.25F), 0),
                       {0, 0, 1},
                       {40, 30, 0}};
    Drawing drawing(400, 400, {-7, -6.6}, {7, 7.4});
    const auto place = [](const glm::mat4& m, glm::vec2 p) {
        const glm::vec4 q = m * glm::vec4(p, 0, 1);
        return glm::dvec2(q.x, q.y);
    };
    // The world's grid, from the world to the viewer.
    const glm::mat4 from_world = ask<inverse_of_frame>(out, viewer);
    for (float k = -12; k <= 12; ++k) {
        drawing.line(place(from_world, {40 + k, 15}), place(from_world, {40 + k, 45}), ink::slate, 1);
        drawing.line(place(from_world, {25, 30 + k}), place(from_world, {55, 30 + k}), ink::slate, 1);
    }
    for (int k = 0; k < frames; ++k) {
        const Frame frame = whirl_frame(k);
        const glm::mat4 m = ask<between_frames>(out, frame, viewer);
        const bool left = ask<orientation>(out, frame) < 0;
        const auto share = static_cast<float>(k) / frames;
        const glm::vec3 color = left ? glm::mix(ink::orange, ink::red, share) : glm::mix(ink::blue, ink::green, share);
        // A flag in the frame's own coordinates: a triangle over x and y tells one hand from the other.
        const std::vector<glm::dvec2> flag = {place(m, {0, 0}), place(m, {1.35F, 0}), place(m, {0, 1.9F})};
        drawing.area(flag, color, 0.55);
        drawing.outline(flag, color, 1.2);
        drawing.arrow(place(m, {0, 0}), place(m, {1.7F, 0}), ink::white, 1.6);
        // A bead of the next frame, which goes to the world and back by the transpose: the frame is Cartesian but for
        // its size.
        const float size = length(frame.x);
        const Frame upright{frame.x / size, frame.y / size, frame.z / size, frame.origin};
        const glm::vec4 bead =
            ask<frame_matrix>(out, upright) *
            (ask<inverse_of_cartesian>(out, upright) * (ask<frame_matrix>(out, frame) * glm::vec4(0.8F, 0.7F, 0, 1)));
        drawing.disc(place(from_world, {bead.x, bead.y}), 3.5 * double{size}, ink::pink);
    }
    return drawing.picture();
}

}
