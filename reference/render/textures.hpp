#pragma once

#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>

#include "scene/scene.hpp"

namespace umbral::render {

/// The texels of a generated texture, linear, alpha 1, top row first. Texels are exact: none is a blend.
[[nodiscard]] Grid<glm::vec4> make_texture(const scene::Texture& texture);

}
