#pragma once

#include <span>
#include <vector>

#include "model/exercise.hpp"
#include "model/scorecard.hpp"

namespace umbral::grader {

/// What the checks of each line of a unit's rubric earned together; nothing for a unit without one. `checks` are the
/// unit's, in its order.
[[nodiscard]] std::vector<RubricScore> by_rubric(const Exercise& exercise, std::span<const CheckResult> checks);

}
