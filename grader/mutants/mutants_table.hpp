#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "mutants/unit_mutants.hpp"

namespace umbral::grader {

/// A unit's line, and below it what is wrong, for the terminal.
[[nodiscard]] std::string mutants_text(const UnitMutants& unit);

/// All units as a page of Markdown: the figures, the survivors, and those that are equivalent with the reason.
[[nodiscard]] std::string mutants_markdown(MutantFamily family, std::span<const UnitMutants> units);

/// The same as JSON, with every mutant.
[[nodiscard]] nlohmann::json mutants_json(std::span<const UnitMutants> units);

}
