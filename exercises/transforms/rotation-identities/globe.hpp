#pragma once

#include <array>
#include <cmath>
#include <kit/drawing.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/rotation_identities.hpp>

/// What a point draws on a sphere that turns about two axes at once: the far side faint, the near side bright.
namespace umbral::transforms {

/// A curve of the globe: a turn about `inner` and one about `outer`, each so many times round while it is drawn.
struct Curve {
    WorldAxis inner;
    float inner_rounds;
    WorldAxis outer;
    float outer_rounds;
    glm::vec3 start;
    glm::vec3 color;
    double width;
};

inline Image draw_globe(Variation& vary, Recorder& out)
{
    constexpr int steps = 1400;
    const std::array<Curve, 6> curves = {{
        {WorldAxis::x, 0, WorldAxis::x, 1, {0, 1, 0}, ink::mist, 1.2},
        {WorldAxis::y, 0, WorldAxis::y, 1, {1, 0, 0}, ink::mist, 1.2},
        {WorldAxis::z, 0, WorldAxis::z, 1, {1, 0, 0}, ink::mist, 1.2},
        {WorldAxis::x, 9, WorldAxis::y, 2, {0, 0, 1}, ink::blue, 2},
        {WorldAxis::z, 5, WorldAxis::x, 2, {0.4F, 0.9165F, 0}, ink::orange, 2},
        {WorldAxis::y, 7, WorldAxis::z, 3, {0.8F, 0, 0.6F}, ink::pink, 2},
    }};
    Drawing drawing(400, 400, {-1.12, -1.12}, {1.12, 1.12});
    drawing.disc({0, 0}, 179, {0.09F, 0.11F, 0.17F});
    const ElementaryTurn camera[] = {{WorldAxis::y, vary.near(-32.0F, 20.0F)}, {WorldAxis::x, vary.near(24.0F, 15.0F)}};
    for (const bool near : {false, true}) {
        for (const Curve& curve : curves) {
            glm::vec3 last(0);
            for (int i = 0; i <= steps; ++i) {
                const float share = static_cast<float>(i) / steps;
                const glm::vec3 inner =
                    ask<elementary_rotation>(out, curve.start, {curve.inner, 360 * curve.inner_rounds * share});
                const glm::vec3 there = ask<after_turns>(
                    out, ask<elementary_matrix>(out, {curve.outer, 360 * curve.outer_rounds * share}) * inner, camera);
                if (i > 0 && (there.z > 0) == near) {
                    const double alpha = near ? 0.55 + 0.45 * double{there.z} : 0.16;
                    // A wrong answer must not cross the picture a thousand times.
                    if (length(there - last) < 0.2F)
                        drawing.line({last.x, last.y}, {there.x, there.y}, curve.color, curve.width, alpha);
                }
                last = there;
            }
        }
    }
    for (const auto& [axis, start, color] : {std::tuple{WorldAxis::y, glm::vec3(1, 0, 0), ink::red},
                                             {WorldAxis::z, {0, 1, 0}, ink::green},
                                             {WorldAxis::x, {0, 0, 1}, ink::blue}}) {
        const glm::vec3 tip = ask<after_turns>(out, ask<elementary_rotation>(out, start, {axis, 360}), camera);
        drawing.arrow({0, 0}, {tip.x, tip.y}, color, 3.5);
    }
    return drawing.picture();
}

}
