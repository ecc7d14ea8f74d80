#pragma once

#include <glm/glm.hpp>

#include "render/rays/world.hpp"

namespace umbral::render::rays {

/// The normal of a place whose material has a bump map (Draw::bump): as if the surface were raised along its normal by
/// the map's heights. Unit, on the side that the ray came from. Where the map's slopes would turn it away from who
/// looks along `direction`, it is bent back until it no longer does.
///
/// What moves is the normal, not the surface: silhouettes and shadows stay as they are. The interpolated normal is that
/// of the surface without its map: the triangle's tangents are laid into the plane across it, so that a flat map
/// changes nothing. Based on: J. Blinn. Simulation of Wrinkled Surfaces. SIGGRAPH 1978. Course: slides F7 to F13, the
/// unit texturing/bump, whose functions these are.
[[nodiscard]] glm::vec3 bumped(const World& world, const Seen& seen, const glm::vec3& direction);

}
