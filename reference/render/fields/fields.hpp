#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "scene/shape.hpp"

namespace umbral::render::fields {

/// How far a place is from a surface, or less: negative inside of it. Between two places it differs by no more than
/// they are apart.
using Distance = std::function<double(const glm::dvec3&)>;

/// The field of that name. Its surface lies within the cube from -1 to 1, without touching its sides.
///
/// The Mandelbulb's estimate keeps what Distance promises where it was measured, but that is not proved.
[[nodiscard]] Distance field_of(scene::FieldKind kind);

}
