#pragma once

#include <filesystem>

#include "cli/application.hpp"

namespace umbral::grader {

/// `umbral check UNIT --file FILE`: what the student's code in `folder` and the reference make of one file, side by
/// side on the standard output. Returns exit_ok if it is the same, exit_not_right if not. Throws UsageError if the unit
/// reads no files, or if the file is none that can be read or is too large.
[[nodiscard]] int check_file(const Application& application, const Exercise& exercise,
                             const std::filesystem::path& folder, const std::filesystem::path& file);

}
