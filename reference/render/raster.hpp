#pragma once

#include "render/lanes.hpp"
#include "render/rows.hpp"

namespace umbral::render {

/// Some pixels of a row, of those that passed the depth test: the ones in `mask`, from cell `at` of the picture on.
struct Passed {
    std::size_t at;
    IntLanes mask;
    std::array<FloatLanes, 3> weights;  ///< of the corners, perspective-correct
};

/// Draws a triangle into `depths`, a picture of width x height cells followed by lane_count more, by the depth test
/// "less"; `shade(passed)` is called for eight pixels or fewer at a time, `covered(n)` with the length of each row.
///
/// Depths are as exact as the unit's: affine from the row's first pixel, in double, rounded once. Weights are affine
/// shares in float over their sum: off by a few 2^-24, times w over the least w of a corner, since the shares are
/// positive.
template <class Covered, class Shade>
[[gnu::always_inline]] inline void draw_triangle(const std::array<pipeline::WindowVertex, 3>& triangle,
                                                 const Window& window, int width, float* depths, const Covered& covered,
                                                 const Shade& shade)
{
    const Setup setup = set_up(triangle, window);
    const auto& [a, b, c] = triangle;
    const auto& [ea, eb, ec] = setup.edges;
    // Whole numbers below 2^53, as all that is made of them by adding a pixel: exact.
    const glm::dvec3 origin(ea.origin, eb.origin, ec.origin);
    const glm::dvec3 step_x = 256.0 * glm::dvec3(ea.step_x, eb.step_x, ec.step_x);
    const glm::dvec3 step_y = 256.0 * glm::dvec3(ea.step_y, eb.step_y, ec.step_y);
    const glm::dvec3 depth_of = setup.inverse_area * glm::dvec3(a.depth, b.depth, c.depth);
    const glm::dvec3 share_of = setup.inverse_area * glm::dvec3(a.inverse_w, b.inverse_w, c.inverse_w);
    const double depth_step = dot(step_x, depth_of);
    const glm::vec3 share_step(step_x * share_of);

    for_each_run(
        setup, [&](int y, int first, int last) __attribute__((always_inline)) {
            covered(last - first + 1);
            const glm::dvec3 edges = origin + static_cast<double>(first) * step_x + static_cast<double>(y) * step_y;
            const double depth_first = dot(edges, depth_of);
            const glm::vec3 shares(edges * share_of);
            const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
            Distances distances;
            for (int x = first; x <= last; x += lane_count, distances.next()) {
                const std::size_t at = row + static_cast<std::size_t>(x);
                const FloatLanes depth = affine(depth_first, depth_step, distances);
                const IntLanes passes = (lane_numbers <= last - x) & (depth < load<FloatLanes>(depths + at));
                if (!any(passes)) continue;
                store(depths + at, passes, depth);
                const std::array<FloatLanes, 3> share = {shares[0] + share_step[0] * distances.all,
                                                         shares[1] + share_step[1] * distances.all,
                                                         shares[2] + share_step[2] * distances.all};
                const FloatLanes scale = 1.0F / (share[0] + share[1] + share[2]);
                shade(Passed{at, passes, {share[0] * scale, share[1] * scale, share[2] * scale}});
            }
        });
}

}
