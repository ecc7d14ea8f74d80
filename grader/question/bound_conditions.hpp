#pragma once

#include <cstddef>
#include <vector>

#include "question/possible_conditions.hpp"

namespace umbral::grader {

/// Adds the bound of a fact that parts wrong answers from right ones best, and of lengths the two between which all
/// right ones lie, if wrong ones lie on both sides.
void add_bounds(const std::vector<Fact>& facts, std::size_t i, const std::vector<bool>& wrong,
                std::vector<PossibleCondition>& all);

}
