#pragma once

#include <string>
#include <vector>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// One sentence for each noise check that fails or was run again: its seeds, so that whoever reads it can repeat the
/// run.
[[nodiscard]] std::vector<std::string> seeds_of_noise(const UnitResult& unit);

}
