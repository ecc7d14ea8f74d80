#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <umbral/raytracing/intersect.hpp>

namespace umbral::bench {

using Intersect = std::optional<float>(const Ray& ray, const raytracing::Sphere& sphere);

/// A function of one solution of a unit, out of the library that the grader itself loads. All solutions define the same
/// names, hence each is opened for itself (RTLD_LOCAL) and stays open. Throws std::runtime_error that names what is
/// missing.
[[nodiscard]] Intersect* sphere_solution(const std::filesystem::path& units, const std::string& solution);

}
