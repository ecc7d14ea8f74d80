#pragma once

#include <string>

namespace umbral::grader {

/// 64 hexadecimal digits that nobody can guess. Throws std::runtime_error if the kernel has no random numbers.
[[nodiscard]] std::string random_text();

}
