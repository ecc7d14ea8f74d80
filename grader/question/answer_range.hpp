#pragma once

#include <optional>
#include <string>
#include <vector>

#include "question/answer_patterns.hpp"

namespace umbral::grader {

/// Bounds that a student's answers never pass, though right ones do.
struct AnswerRange {
    std::string words;    ///< they follow "every wrong answer"
    bool is_cut = false;  ///< each wrong answer is the bound that the right one is beyond
};

/// "is 0 where the right one is less", "is the right one cut to 0 to 1", "is never above 1, though right ones are": of
/// the numbers of a row in these places, in all answers, wrong or not. Nothing if fewer than least_wrong right ones are
/// beyond a bound, or if no answer lies at it: then it is where they end by chance.
[[nodiscard]] std::optional<AnswerRange> range_of_answers(const AnswerTable& table,
                                                          const std::vector<const AnswerPair*>& wrong,
                                                          const std::vector<std::size_t>& which);

}
