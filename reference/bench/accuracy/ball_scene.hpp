#pragma once

#include <umbral/core/random.hpp>
#include <umbral/raytracing/triangle.hpp>
#include <vector>

namespace umbral::bench {

/// A ball of radius ½ made of 2 slices (slices / 2 - 1) triangles (slices even).
[[nodiscard]] std::vector<raytracing::Triangle> ball_triangles(std::uint32_t slices);

/// Rays from two units away at points of a cube that just holds the ball: about half of them hit.
[[nodiscard]] std::vector<Ray> rays_at_ball(int count, Random& random);

}
