#pragma once

#include <array>
#include <umbral/transforms/pipeline.hpp>

namespace umbral::transforms {

/// The corners of the trunk, counter-clockwise; corners 2, 5 and 8 point inwards, so the polygon is concave. Its base,
/// from corner 0 to corner 1, has length 1.
inline constexpr std::array<glm::vec2, 9> trunk_polygon{
    {{0, 0}, {1, 0}, {1, 1}, {2, 2}, {1.5F, 2.5F}, {0.5F, 1.5F}, {0, 3}, {-0.5F, 3}, {0, 1.5F}}};

inline constexpr glm::vec3 trunk_fill{0.68F, 0.85F, 0.90F};   ///< light blue
inline constexpr glm::vec3 trunk_edges{0.00F, 0.00F, 0.55F};  ///< dark blue

/// The trunk: the polygon filled with light blue, every place of it once, and on it six of its nine edges in dark blue,
/// in the current line width.
///
/// The edges 0-1 (the base), 3-4 and 6-7 (the ends of the branches) are not drawn, so that trunks grow out of each
/// other. Neutral. Course: problem 2.22, Tronco.
void draw_trunk(Pipeline& pipeline);

/// The tree: `trunk`, and on the ends of its branches two trees of one level less, scaled and turned, not mirrored, so
/// that their bases are these ends. A tree of level 0 is nothing.
///
/// In the order trunk, left tree, right tree. The left tree's corners 0 and 1 lie on the trunk's corners 7 and 6, the
/// right tree's on its corners 4 and 3. Draws with `trunk` only; neutral. One push a level is enough: OpenGL's own
/// stack holds 32 matrices. Course: problem 2.23, Arbol.
void draw_tree(Pipeline& pipeline, unsigned levels, const Figure& trunk);

}
