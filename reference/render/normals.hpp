#pragma once

#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>

#include "render/draw_list.hpp"
#include "render/frame.hpp"

namespace umbral::render {

/// The same things, dull and white, in three lights from far away, red from the viewer's right, green from above, blue
/// from behind the viewer: a picture of max(0, n) for the normal n in eye space. `opposite`: the lights stand on the
/// other sides, for max(0, -n). Any renderer of local illumination shows its normals so, whether it has a buffer for
/// them or not.
[[nodiscard]] DrawList normals_list(const DrawList& list, bool opposite);

/// n of the two pictures, where something was drawn; its length is 1 where the renderer makes normals unit at pixels.
[[nodiscard]] Grid<glm::vec3> normals_of(const Frame& positive, const Frame& negative);

}
