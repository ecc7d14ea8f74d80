#pragma once

#include <string>

namespace umbral::grader {

/// Makes an offscreen OpenGL context current for this process and all its forks, and draws once, so that every run
/// finds the shader compiler ready. Returns what draws.
[[nodiscard]] std::string warm_gl();

}
