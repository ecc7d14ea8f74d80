#pragma once

#include <optional>
#include <vector>

#include "question/conditions.hpp"

namespace umbral::grader {

/// A condition that holds wherever answers are wrong, and hardly where they are right: not all answers are wrong where
/// it holds, but all are right elsewhere. The one for which it holds of the fewest right ones, or of about as few and
/// simpler. Nothing if it may well be chance, or holds nearly everywhere.
[[nodiscard]] std::optional<Condition> one_sided_condition(const std::vector<Fact>& facts,
                                                           const std::vector<bool>& wrong);

}
