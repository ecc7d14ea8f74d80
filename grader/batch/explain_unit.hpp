#pragma once

#include <vector>

#include "batch/case_results.hpp"
#include "batch/workshop.hpp"

namespace umbral::grader {

/// Why a unit's checks fail: known mistakes that give the same results, and named transforms that undo the difference; best first.
/// Runs the unit's mistakes on the failing cases, in the sandbox like everything else.
[[nodiscard]] std::vector<Explanation> explain_unit(Workshop& workshop, const Exercise& exercise, const UnitResult& result, const CaseResults& cases);

}
