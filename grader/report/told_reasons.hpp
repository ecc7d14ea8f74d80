#pragma once

#include <vector>

#include "model/scorecard.hpp"
#include "report/block.hpp"

namespace umbral::grader {

/// What wrong answers have in common and what they depend on, of the check that is shown, the first; and where no
/// reason is known and that is nothing, or only where they lie, of the first other of which more is known.
void add_pattern(Block& block, const UnitResult& unit, const std::vector<const CheckResult*>& failing);

/// The line of the student's own file where wrong answers part from right ones, of the first check of which it is
/// known.
void add_code_place(Block& block, const UnitResult& unit, const CheckResult* shown, const Paint& paint);

/// The reasons that are known.
void add_reasons(Block& block, const UnitResult& unit);

}
