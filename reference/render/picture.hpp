#pragma once

#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>

#include "render/frame.hpp"
#include "scene/scene.hpp"

namespace umbral::render {

/// The sRGB value of a linear one, both in [0, 1]: clamped, not rounded. NaN gives 0. Source as below.
[[nodiscard]] double encoded(float linear);

/// The sRGB value of a linear one, in 0 to 255: clamped to [0, 1], rounded to the nearest. NaN gives 0.
/// Based on: IEC 61966-2-1. 1999.
[[nodiscard]] std::uint8_t to_srgb(float linear);

/// The picture for a file: what was drawn over the scene's background, each pixel the mean of samples x samples of the
/// frame's, averaged as light. Encoded once, at the end. The frame's sides must be multiples of `samples`.
[[nodiscard]] Image make_picture(const Frame& frame, const scene::Scene& scene, int samples = 1);

/// Pictures of the other buffers, to look at: nearer is lighter, from the nearest depth drawn to the farthest; every id
/// has a colour of its own; what is covered is white.
[[nodiscard]] Image picture_of_depth(const Frame& frame);
[[nodiscard]] Image picture_of_ids(const Frame& frame);
[[nodiscard]] Image picture_of_coverage(const Frame& frame);

}
