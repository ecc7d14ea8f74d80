#pragma once

#include <string>
#include <vector>

#include "build/builder.hpp"
#include "build/submission.hpp"
#include "cli/application.hpp"

namespace umbral::grader {

/// The files of one unit in a student's workspace, and their build.
struct BuiltWork {
    Sources files;
    Built built;
};

/// Reads and builds a unit's files in the workspace `folder`, after what the unit itself needs; the compiler is told
/// `flags` beside its own. Throws UsageError, with the file's name or the compiler's words, if a file is missing,
/// refused or does not compile.
[[nodiscard]] BuiltWork built_work(const Application& application, const Exercise& exercise, const std::string& folder,
                                   const std::vector<std::string>& flags = {});

}
