#pragma once

#include <cstddef>
#include <vector>

#include "question/answer_patterns.hpp"

namespace umbral::grader {

/// What the wrong columns of square matrices are, or else their rows, if that can be said of most of them: "is right
/// but for some columns: column 1 is the right column 0". `which` are the numbers that are wrong, column by column.
/// Nothing for rows of numbers that are no matrices.
[[nodiscard]] std::vector<AnswerPattern> matrix_line_patterns(const AnswerTable& table,
                                                              const std::vector<const AnswerPair*>& wrong,
                                                              const std::vector<std::size_t>& which);

}
