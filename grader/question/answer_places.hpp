#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "question/answer_patterns.hpp"

namespace umbral::grader {

/// The components of a row in which some wrong answer differs by more than rounding. All must be as long as the right
/// ones.
[[nodiscard]] std::vector<std::size_t> wrong_components(const std::vector<const AnswerPair*>& wrong,
                                                        std::size_t components);

/// Where a row is wrong, of the components that are, by what its columns are called: "differs in y only", "differs in
/// column 3 only". Empty if most of what it says is, or if the one row that is shown says it as well.
[[nodiscard]] std::string place_of(const AnswerTable& table, const std::vector<std::size_t>& which,
                                   const std::vector<std::string>& columns);

/// "differs in other numbers than y", of three numbers or more that have names, where y is not the same everywhere. Not
/// where it is the least: of indices that begin with the smallest the first is right by itself.
[[nodiscard]] std::string all_but_one(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong,
                                      const std::vector<std::size_t>& which, const std::vector<std::string>& columns);

}
