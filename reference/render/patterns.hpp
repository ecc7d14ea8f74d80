#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"

/// Materials of nature as textures: computed from the place alone, the same on every machine, and joining themselves
/// without a seam.
namespace umbral::render {

/// Smooth noise in [-1, 1] that repeats after `period` (whole numbers, at least 1) along x and y; 0 on no particular
/// line. Gradient noise by Perlin (2002), with a quintic fade.
[[nodiscard]] float periodic_noise(const glm::vec2& place, const glm::ivec2& period);

/// Boards side by side along u, with the rings of a trunk that is cut along.
[[nodiscard]] glm::vec3 wood(const scene::Texture& texture, const glm::vec2& uv);

/// Veins of the second colour in the first.
[[nodiscard]] glm::vec3 marble(const scene::Texture& texture, const glm::vec2& uv);

/// Layers of bricks, every other one by half a brick aside; they join themselves above if their number is even.
[[nodiscard]] glm::vec3 bricks(const scene::Texture& texture, const glm::vec2& uv);

/// Round dimples, as in the peel of an orange, one in each cell, not all as deep.
[[nodiscard]] glm::vec3 pores(const scene::Texture& texture, const glm::vec2& uv);

}
