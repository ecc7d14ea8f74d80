#pragma once

#include <string>
#include <vector>

#include "judge/statistics/stochastic.hpp"

namespace umbral::grader {

/// Beside the quantity of a table that is farthest off, what is known of the others: "Of the 3 others 2 are off as
/// well: the light of a slanted lamp by -25 %, the light of a near lamp by +12 %." `names`: of all, or fewer. Empty
/// where there are no others.
[[nodiscard]] std::string others_in_words(const Estimates& yours, const Estimates& expected, int worst,
                                          const Forgiven& forgiven, const std::vector<std::string>& names);

}
