#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "explain/explained_checks.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader {

/// How the names of such explanations begin.
inline constexpr std::string_view two_mistakes_begin = "mistakes: ";

/// "mistakes: A and B"
[[nodiscard]] std::string two_mistakes_title(const std::string& a, const std::string& b);

/// Two of the unit's mistakes that were made together, where no single one is the reason: every failing check that is
/// looked at deviates, row by row, as one of the two does, and in half or more of the rows that this one alone gets
/// wrong; each is needed, and what passes would pass with both. At most one explanation; none if two pairs do as well.
[[nodiscard]] std::vector<Explanation> by_two_mistakes(Worker& worker, const Exercise& exercise,
                                                       std::span<const CaseChecks> groups,
                                                       std::span<const KnownSolution> mistakes);

}
