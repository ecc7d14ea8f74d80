#pragma once

#include <string>

#include "scene/shape.hpp"

namespace umbral::scene {

/// The mesh in the text of an OBJ file: positions, faces as fans of triangles, texture coordinates (none, if no face
/// has any; (0, 0) at corners without, if others have some). Materials, groups, normals and curves are left out.
///
/// Coordinates are finite, indices are in range, and there are at most maximum_vertices positions, triangles, and
/// texture coordinates; there may be none at all. Throws std::runtime_error "line 3: expected …, got …", or
/// "face 2: …", counted from 1.
[[nodiscard]] Triangles read_obj(const std::string& text);

}
