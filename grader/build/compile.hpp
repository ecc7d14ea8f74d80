#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "build/submission.hpp"
#include "build/toolchain.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

struct Compilation {
    std::optional<std::filesystem::path> library;  ///< empty if the compiler or the linker refused
    std::string diagnostics;                       ///< the first errors, with the student's own file names
    bool out_of_time = false;                      ///< the compiler was stopped: on a less busy machine it might not be
};

/// Writes `files` into the empty folder `work` and makes `work/student.so` of its .cpp files, in confinement: the compiler sees the
/// folder, /usr and the framework's headers. Exported are exactly the names in the unit's exports.map.
[[nodiscard]] Compilation compile(const Toolchain& tools, const Exercise& exercise, const Sources& files, const std::filesystem::path& work);

/// The first errors of g++ output, with their notes and source lines, at most `lines` lines.
[[nodiscard]] std::string first_errors(std::string_view output, std::size_t lines);

}
