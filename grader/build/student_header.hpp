#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "build/toolchain.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

/// What the compiler is told so that a student's file of a unit is read after the header of all units, which is
/// precompiled, and the unit's own interfaces: no macro of the student's can change what the driver shares with it.
[[nodiscard]] std::vector<std::string> read_first(const Toolchain& tools, const Exercise& exercise);

/// A precompiled header works with one compiler only, so a package cannot bring one: it is made on first use, from
/// `text`, as `tools.student_header` and the file beside it.
///
/// Is it there, made by the compiler as it is now, of the headers as they are now? Looks at sizes and times of all of
/// them.
[[nodiscard]] bool is_header_ready(const Toolchain& tools, const std::filesystem::path& text);

/// Makes it if it is not there; takes some seconds. One at a time: a second call waits for the first. Throws
/// std::runtime_error that says what the compiler said.
void make_header(const Toolchain& tools, const std::filesystem::path& text);

}
