#pragma once

#include <string>

namespace umbral::grader {

/// The first line that `program` prints when it is called with `arguments`; empty if it cannot be run or prints
/// nothing. Goes through the shell: both come from the build's own configuration, never from a submission.
[[nodiscard]] std::string ask_program(const std::string& program, const std::string& arguments);

}
