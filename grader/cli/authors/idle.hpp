#pragma once

#include <string>
#include <vector>

#include "cli/application.hpp"

namespace umbral::grader {

/// What a program that does nothing earns in each of these units, or in all. `quiet`: only where it is too much.
void validate_idle(Application& application, const std::vector<std::string>& units, std::size_t jobs, bool quiet);

}
