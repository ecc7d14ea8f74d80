#pragma once

#include <span>

#include "cli/commands.hpp"

namespace umbral::grader {

/// What main() does in umbral and in umbral-authors: reads the words, the program's own name first, and runs the
/// command that they name; of a command that this program does not have, umbral-authors runs instead. What is wrong is
/// said on the standard error stream, as "umbral: …" from either. Returns the exit status.
[[nodiscard]] int run_program(std::span<char* const> words, std::span<const ListedCommand> commands);

}
