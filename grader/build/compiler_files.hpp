#pragma once

#include <string>
#include <vector>

namespace umbral::grader {

/// What this compiler reads of the system to compile and link C++, as rules for a confined program: its own folder, the
/// system's headers, programs, and the files (not the folders) beside the libraries. Asked of the compiler once and
/// remembered. Throws std::runtime_error if it cannot be run.
[[nodiscard]] const std::vector<std::string>& compiler_files(const std::string& compiler);

}
