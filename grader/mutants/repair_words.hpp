#pragma once

#include <string>

#include "mutants/mutant.hpp"

namespace umbral::grader {

/// What to look at in the place of a change that mends work, in a sentence that does not give the change away.
[[nodiscard]] std::string words_of_repair(const Mutant& change);

}
