#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "question/answer_patterns.hpp"

namespace umbral::grader {

/// Do the first `keys` numbers of a list's rows say no more than places in it: is each the same in all rows, or the
/// row's number?
[[nodiscard]] bool keys_are_places(std::span<const double> rows, std::size_t components, std::size_t keys);

/// What is missing, too much or out of order in each of these wrong answers, which are lists of rows: "lacks the last
/// row", "has its rows in the opposite order".
[[nodiscard]] std::vector<std::string> list_patterns(const AnswerTable& table,
                                                     const std::vector<const AnswerPair*>& wrong);

/// Of lists whose rows are of kinds with names: which kind, the same one, is missing in all, or too much: `lacks a
/// "zoom"`, `has "zoom" too often`. Nothing where it is not one kind alone.
[[nodiscard]] std::vector<std::string> kind_patterns(const AnswerTable& table,
                                                     const std::vector<const AnswerPair*>& wrong);

}
