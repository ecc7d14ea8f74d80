#pragma once

#include <array>
#include <cmath>
#include <kit/drawing.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/perpendicular.hpp>

/// A tree of Pythagoras: on every square a right-angled triangle, on its legs two smaller squares, all by P and
/// rotations.
namespace umbral::transforms {

struct Branch {
    glm::vec2 foot;
    glm::vec2 side;
    float lean;
    int depth;
};

inline Image draw_tree(Variation& vary, Recorder& out)
{
    constexpr int deepest = 11;
    constexpr std::array<glm::vec3, 5> stops = {glm::vec3(0.36F, 0.24F, 0.20F),
                                                {0.55F, 0.36F, 0.22F},
                                                ink::green,
                                                {0.55F, 0.80F, 0.35F},
                                                {0.95F, 0.75F, 0.45F}};
    Drawing drawing(400, 400, {-3.5, -0.7}, {3.3, 5.3});
    drawing.line({-4, 0}, {5, 0}, ink::slate, 3);
    // Breadth first: no more squares than a binary tree of this depth has, whatever the functions give.
    std::vector<Branch> branches = {{{-0.5F, 0}, {1, 0}, vary.near(0.66F, 0.15F), 0}};
    const float even = vary.near(0.86F, 0.1F);
    const float odd = vary.near(0.72F, 0.1F);
    for (std::size_t i = 0; i < branches.size(); ++i) {
        const Branch branch = branches[i];
        // Sides shrink; one that grows is a wrong answer, and would take long to paint.
        if (!(length(branch.side) < 1.5F)) continue;
        const glm::vec2 up = ask<turn_left>(out, branch.side);
        const glm::vec2 top = branch.foot + up;
        const float place = 4 * static_cast<float>(branch.depth) / deepest;
        const auto stop = std::min(static_cast<std::size_t>(place), stops.size() - 2);
        const glm::vec3 color = glm::mix(stops[stop], stops[stop + 1], place - static_cast<float>(stop));
        const std::vector<glm::dvec2> square = {branch.foot, branch.foot + branch.side, top + branch.side, top};
        drawing.area(square, color, 0.9);
        drawing.outline(square, 0.55F * color, 1);
        if (branch.depth == deepest) continue;
        // The legs: one leans by an angle from the side, the other stands at a right angle to the first.
        const glm::vec2 first = std::cos(branch.lean) * ask<rotate_in_plane>(out, branch.side, branch.lean);
        const glm::vec2 second = std::tan(branch.lean) * ask<turn_right>(out, first);
        const float next = branch.depth % 2 == 0 ? even : odd;
        branches.push_back({top, first, next, branch.depth + 1});
        branches.push_back({top + first, second, next, branch.depth + 1});
    }
    return drawing.picture();
}

}
