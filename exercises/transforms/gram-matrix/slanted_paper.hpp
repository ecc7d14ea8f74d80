#pragma once

#include <cmath>
#include <kit/drawing.hpp>
#include <numbers>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/gram_matrix.hpp>
#include <vector>

/// The unit circle in two oblique bases, a right-handed and a left-handed one: to the left the coordinates, on squared
/// paper; to the right the vectors, on slanted paper. Spokes and the chords across them are perpendicular to the right.
namespace umbral::transforms {

/// A basis of the plane, with the world's z for its third vector, and where its two papers lie.
struct SlantedPaper {
    glm::mat3 basis;
    glm::dvec2 coordinates;
    glm::dvec2 vectors;
};

inline void draw_paper(Recorder& out, Drawing& drawing, const SlantedPaper& paper)
{
    constexpr int spokes = 96;
    const auto on_squares = [&](glm::vec3 a) { return paper.coordinates + glm::dvec2(a.x, a.y); };
    const auto on_slants = [&](glm::vec3 a) {
        const glm::vec3 v = paper.basis * a;
        return paper.vectors + glm::dvec2(v.x, v.y);
    };
    for (float k = -1.5F; k <= 1.5F; k += 0.5F) {
        const auto lines = [&](const auto& place) {
            drawing.line(place({k, -1.5F, 0}), place({k, 1.5F, 0}), ink::slate, 1);
            drawing.line(place({-1.5F, k, 0}), place({1.5F, k, 0}), ink::slate, 1);
        };
        lines(on_squares);
        lines(on_slants);
    }
    const glm::mat3 gram = ask<gram_matrix>(out, paper.basis);
    for (int spoke = 0; spoke < spokes; ++spoke) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(spoke) / spokes;
        const glm::vec3 direction(std::cos(angle), std::sin(angle), 0);
        const glm::vec3 unit = direction / std::sqrt(ask<dot_from_gram>(out, gram, direction, direction));
        const glm::vec3 across = 0.16F * ask<cross_in_basis>(out, paper.basis, {0, 0, 1}, unit);
        const float sine = ask<area_from_gram>(out, gram, unit, {1, 0, 0}) / std::sqrt(gram[0][0]);
        const glm::vec3 color = glm::mix(ink::blue, ink::orange, sine);
        const auto mark = [&](const auto& place) {
            drawing.line(place(0.35F * unit), place(unit), color, 1.5, 0.8);
            if (spoke % 4 == 0) drawing.arrow(place(unit), place(unit + across), ink::white, 1.8);
            drawing.disc(place(unit), 2.4, color);
        };
        mark(on_squares);
        mark(on_slants);
    }
    for (int i = 0; i < 2; ++i) {
        glm::vec3 axis(0);
        axis[i] = 1;
        drawing.arrow(on_squares({0, 0, 0}), on_squares(axis), ink::pink, 2.5);
        drawing.arrow(on_slants({0, 0, 0}), on_slants(axis), ink::pink, 2.5);
    }
}

inline Image draw_slanted_paper(Variation& vary, Recorder& out)
{
    Drawing drawing(560, 560, {-4.2, -4.2}, {4.2, 4.2});
    const auto lean = [&](float x, float y) { return glm::vec3(vary.near(glm::vec2(x, y), 0.15F), 0); };
    draw_paper(out, drawing, {{lean(1, 0.15F), lean(0.45F, 0.8F), {0, 0, 1}}, {-2.1, 2}, {2.1, 2}});
    draw_paper(out, drawing, {{lean(0.3F, 1), lean(0.9F, 0.1F), {0, 0, 1}}, {-2.1, -2}, {2.1, -2}});
    return drawing.picture();
}

}
