#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <kit/color.hpp>
#include <kit/drawing.hpp>
#include <umbral/projections/viewport.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// The goal picture of this unit: a window of few pixels, magnified, with three viewports that show one flower.
namespace umbral::projections {

/// How far the flower's border is from the middle, in normalised device coordinates.
inline float petal(float angle) { return 0.66F + 0.26F * std::cos(6 * angle); }

/// The colour of the scene at a place, sRGB.
inline glm::vec3 flower_color(const glm::vec2& ndc)
{
    const float distance = length(ndc);
    const float angle = std::atan2(ndc.y, ndc.x);
    if (distance < 0.24F) return {0.98F, 0.80F, 0.25F};
    if (distance < petal(angle))
        return glm::mix(glm::vec3(0.96F, 0.93F, 0.96F), glm::vec3(0.83F, 0.25F, 0.48F), distance);
    return glm::mix(glm::vec3(0.16F, 0.36F, 0.36F), glm::vec3(0.09F, 0.21F, 0.25F), 0.7F * distance);
}

/// Pixels have the colour of their middles; over them lies the flower's true outline, and rings mark the pixels that
/// points of a spiral fall into.
inline Image draw_flowers(Recorder& out, Variation vary = {})
{
    constexpr glm::ivec2 window(60, 40);
    // The cross that parts them lies elsewhere if inputs are to vary.
    const int column = vary.near(39, 6);
    const int row = vary.near(18, 5);
    const int left_height = vary.near(36, 4);
    const Viewport viewports[] = {{2, 38 - left_height, column - 3, left_height},
                                  {column + 2, row + 2, 56 - column, 36 - row},
                                  {column + 2, 2, 56 - column, row - 3}};
    Drawing drawing(480, 320, {0, 0}, window);
    for (const Viewport& viewport : viewports) {
        for (int j = viewport.bottom; j < viewport.bottom + viewport.height; ++j)
            for (int i = viewport.left; i < viewport.left + viewport.width; ++i) {
                const glm::vec2 centre = ask<pixel_centre>(out, viewport, glm::ivec2(i, j));
                constexpr double gap = 0.05;
                const glm::dvec2 low(i + gap, j + gap);
                const glm::dvec2 high(i + 1 - gap, j + 1 - gap);
                drawing.area(std::vector<glm::dvec2>{low, {high.x, low.y}, high, {low.x, high.y}},
                             flower_color(centre));
            }
        const glm::mat4 matrix = ask<viewport_matrix>(out, viewport);
        std::vector<glm::dvec2> outline;
        for (int step = 0; step < 180; ++step) {
            const float angle = static_cast<float>(step) * 6.2831853F / 180;
            outline.emplace_back(matrix *
                                 glm::vec4(petal(angle) * std::cos(angle), petal(angle) * std::sin(angle), 0, 1));
        }
        drawing.outline(outline, ink::white, 1.6);
        for (int step = 3; step < 9; ++step) {
            const float angle = 2.4F * static_cast<float>(step);
            const float distance = 0.11F * static_cast<float>(step);
            const glm::vec2 place(distance * std::cos(angle), distance * std::sin(angle));
            if (const auto pixel = ask<pixel_at>(out, viewport, place))
                drawing.ring(glm::dvec2(*pixel) + 0.5, 2.6, ink::blue, 1.6);
        }
    }
    return drawing.picture();
}

}
