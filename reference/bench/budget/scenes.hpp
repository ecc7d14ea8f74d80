#pragma once

#include <filesystem>
#include <vector>

#include "scene/scene.hpp"

namespace umbral::bench {

/// Eight scenes: hard edges, mirrors and glass, lights and lenses of several sizes, light between surfaces. Read from
/// the folder of the engine's scenes, some of them changed. Throws std::runtime_error if one cannot be read.
[[nodiscard]] std::vector<scene::Scene> budget_scenes(const std::filesystem::path& folder);

}
