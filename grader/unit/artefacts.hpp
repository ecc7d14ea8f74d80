#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "model/exercise.hpp"

namespace umbral::grader {

/// What the file of a check is called, among those of all units: "raytracing-sphere-far-away-t.png".
[[nodiscard]] std::string artefact_name(const Exercise& exercise, const Check& check, const char* extension);

/// Makes the folder of artefacts in a folder that exists. It may lie in a workspace that somebody else has sent
/// (store/sent_folder.hpp): throws RefusedFolder if it is a link.
void make_artefact_folder(const std::filesystem::path& folder);

/// Writes a file there, in place of whatever has its name: a link is replaced and not followed, and no pipe is waited
/// for. Throws std::runtime_error.
void write_artefact(const std::filesystem::path& file, std::span<const std::byte> bytes);

}
