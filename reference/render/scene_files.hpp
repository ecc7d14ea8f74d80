#pragma once

#include <filesystem>
#include <vector>

namespace umbral::render {

/// The scene at `place`, or all scenes of a folder (files that end in .json, in the order of their names). Throws
/// std::runtime_error if a folder has none.
[[nodiscard]] std::vector<std::filesystem::path> scenes_of(const std::filesystem::path& place);

}
