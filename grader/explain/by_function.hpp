#pragma once

#include <span>
#include <vector>

#include "explain/function_parts.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader {

/// Named transforms of one function's answers, where failing checks hold those of several: a matrix that one function
/// of four transposes is no transposed table. Only the rows whose questions are known to be that function's are looked
/// at. An explanation's `fit` is at most the share of failing tables whose wrong rows are all this function's, so that
/// what explains a part is not taken for all that is wrong.
[[nodiscard]] std::vector<Explanation> transforms_by_function(const FunctionParts& parts);

/// Known mistakes in the answers of one function of several, with the same `fit`: a mistake that the unit's list makes
/// in all loops may be made in one, and one that is made beside another in another function explains what it explains.
/// It must agree with all that the function answered.
[[nodiscard]] std::vector<Explanation> mistakes_by_function(Worker& worker, const Exercise& exercise,
                                                            const FunctionParts& parts,
                                                            std::span<const KnownSolution> mistakes);

}
