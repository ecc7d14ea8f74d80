#pragma once

#include <span>
#include <vector>

#include "explain/explained_checks.hpp"

namespace umbral::grader {

/// Named transforms of one function's answers, where failing checks hold those of several: a matrix that one function
/// of four transposes is no transposed table. Only the rows whose questions are known to be that function's are looked
/// at. An explanation's `fit` is at most the share of failing tables whose wrong rows are all this function's, so that
/// what explains a part is not taken for all that is wrong.
[[nodiscard]] std::vector<Explanation> by_function(Worker& worker, const Exercise& exercise,
                                                   std::span<const CaseChecks> groups);

}
