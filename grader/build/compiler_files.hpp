#pragma once

#include <string>
#include <vector>

namespace umbral::grader {

/// What this compiler reads of the system to compile and link C++, as rules for a confined program: its own folder, the
/// headers of the C++ and C libraries, of OpenGL, GLFW and GLM, programs, and the files (not the folders) beside the
/// libraries. Headers that other libraries have in folders of their own (Eigen, Boost, OpenCV) are not among them: to a
/// student's file they are not there. Asked of the compiler once and remembered. Throws std::runtime_error if it cannot
/// be run.
[[nodiscard]] const std::vector<std::string>& compiler_files(const std::string& compiler);

}
