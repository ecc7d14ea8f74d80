#pragma once

#include <string>
#include <vector>

#include "cli/application.hpp"

namespace umbral::grader {

/// Prints what each of these units, or all, never asks of a student's functions: where unforeseen mistakes may hide.
void print_gaps(Application& application, const std::vector<std::string>& units, std::size_t jobs, unsigned seeds);

}
