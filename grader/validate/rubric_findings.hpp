#pragma once

#include <string>
#include <vector>

#include "validate/validate.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader {

/// What is wrong with the result of a mistake that breaks one line of the unit's rubric: that line must lose points,
/// and no other may. "" if so. `line` counts from 0, in the text from 1.
[[nodiscard]] std::string rubric_complaint(std::size_t line, const UnitResult& result);

/// A finding for each line of a unit's rubric that no mistake names. Nothing where the unit has no rubric.
[[nodiscard]] std::vector<Finding> expect_rubric(const Exercise& exercise, const std::vector<KnownSolution>& mistakes,
                                                 unsigned seed);

}
