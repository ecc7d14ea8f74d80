#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "question/answer_patterns.hpp"

namespace umbral::grader {

/// What the numbers of the rows in which wrong answers differ are called: the table's columns, or those of the kind of
/// rows, if all of these are of one kind. Nothing if they have no names. All answers must be as long as the right ones.
[[nodiscard]] std::vector<std::string> columns_of_wrong_rows(const AnswerTable& table,
                                                             const std::vector<const AnswerPair*>& wrong);

/// Numbers of a row that are called by a name together, "centre" for "centre.x", "centre.y" and "centre.z".
struct NumbersTogether {
    std::string name;
    std::size_t first = 0;
    std::size_t size = 1;
};

/// The columns by the name before their last point or bracket; one that has neither stands alone.
[[nodiscard]] std::vector<NumbersTogether> together(const std::vector<std::string>& columns);

}
