#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace umbral::scene {

/// Reads a scene (docs/schemas/scene.schema.json describes the format; limits.hpp how large it may be).
///
/// What is read can be drawn: names refer to things that exist, indices are in range, numbers are finite, and no factor
/// or direction is zero. Names stand for places in Scene's lists, so that nothing can refer to itself. Throws
/// std::runtime_error "file: instances[2].geometry: expected …, got …".
///
/// The files of its meshes are read as well: every MeshFile becomes Triangles.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file);

/// The same from a text, and nothing else: a MeshFile stays one. `file` is what complaints call the text.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& file);

}
