#pragma once

#include <string>
#include <vector>

#include "build/toolchain.hpp"

namespace umbral::grader {

/// Where things lie on this machine, which is nobody's business who reads what a run printed or threw
/// (RunRequest::roots).
[[nodiscard]] std::vector<std::string> run_roots(const Toolchain& tools);

}
