#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "build/toolchain.hpp"
#include "model/exercise.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader {

// A students' package holds no source of an answer: neither reference nor mistakes nor alternatives. What grading needs
// of them is written down when the package is made, for each unit:
//
//   packaged.json   in the unit's folder: its digest; each mistake's name, what it is, its hint, its verdict if
//   declared shaders         beside the unit's driver, for units in GLSL only: the texts of the reference and of the
//   mistakes NAME.veiled     instead of NAME.so: the libraries of reference, oracle and mistakes, some of which hold
//   shaders as texts
//
// The last two are veiled: no search, no editor and no disassembler shows what is in them. Whoever reads this room's
// files can lift the veil; what the student's machine must run cannot be kept from the student.

/// Writes both files of a unit into `folder`. Throws std::runtime_error if a solution is malformed or a file cannot be
/// written.
void write_packaged(const std::filesystem::path& reference, const Exercise& exercise,
                    const std::filesystem::path& folder);

/// Replaces the libraries of answers below `units`, a folder of units' folders as in a build, by veiled ones. Throws
/// std::runtime_error if one cannot be written.
void veil_libraries(const std::filesystem::path& units);

/// Is a unit's library `name` there in its veiled form only?
[[nodiscard]] bool is_veiled(const Toolchain& tools, const Exercise& exercise, const std::string& name);

/// Where a unit's library `name` lies, "reference" or "mistakes/far_root": beside the driver, or, if it is veiled
/// there, unveiled below `scratch`, where it is written if it is not there yet.
[[nodiscard]] std::filesystem::path answer_library(const Toolchain& tools, const Exercise& exercise,
                                                   const std::string& name, const std::filesystem::path& scratch);

/// The unit's mistakes: from their sources where these are installed, otherwise from its packaged files; then `credit`
/// is unknown and of C++ there are no sources. Throws std::runtime_error that names the file.
[[nodiscard]] std::vector<KnownSolution> known_mistakes(const Toolchain& tools, const Exercise& exercise);

/// What a run of the reference compiles itself: the shaders of a unit in GLSL, nothing of others. As above.
[[nodiscard]] Sources reference_shaders(const Toolchain& tools, const Exercise& exercise);

}
