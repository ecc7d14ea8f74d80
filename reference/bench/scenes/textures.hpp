#pragma once

#include <umbral/core/grid.hpp>

/// Textures, computed; none is symmetric, so that flips show. The first row is v = 0.
namespace umbral::bench::scenes {

/// Cells of two colours, with one corner of each marked.
[[nodiscard]] Image tiles(int size, int cells, const glm::vec3& first, const glm::vec3& second);
/// Threads of many colours, hardly wider than a texel.
[[nodiscard]] Image weave(int size);
/// Coloured discs and bars over a gradient: a picture of its own.
[[nodiscard]] Image painting(int size);
/// Leaves with nothing between them (alpha 0), soft at their edges.
[[nodiscard]] Image leaves(int size);
/// A normal map of bumps.
[[nodiscard]] Image bumps(int size);
/// White, fading out from the middle.
[[nodiscard]] Image glow(int size);
/// Bricks.
[[nodiscard]] Image bricks(int size);

}
