#pragma once

#include "render/rays/draw.hpp"
#include "scene/scene.hpp"

namespace umbral::render::rays {

/// Does anything move while the camera's shutter is open?
[[nodiscard]] bool is_blurred_by_motion(const scene::Scene& scene);

/// draw_by_rays of a scene whose shutter opens at a time and stays open for the camera's shutter_seconds: the mean of
/// pictures of as many moments as there are rays through a pixel, 64 at most, evenly in that time. Each moment gets its
/// share of a pixel's rays, which together are the rays of the picture of one moment. Depth and ids are those of the
/// first moment. Where nothing moves, it is the picture of that time. Errors as draw_by_rays'.
/// Based on: R. L. Cook, T. Porter, L. Carpenter. Distributed Ray Tracing. 1984, section 4.
[[nodiscard]] Frame draw_with_open_shutter(const scene::Scene& scene, double seconds, int width, int height,
                                           const Effort& effort, RayCounts* counts = nullptr);

}
