#pragma once

#include <cstddef>
#include <optional>

#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Of the questions behind the rows of a check that count, how many were answered rightly in each row.
struct RightQuestions {
    std::size_t right = 0;
    std::size_t all = 0;
};

/// Nothing where rows have no questions of their own (pictures, events), or the run left nothing to be judged.
[[nodiscard]] std::optional<RightQuestions> right_questions(Worker& worker, const Exercise& exercise,
                                                            const Check& check, const CaseResult& one);

/// Is the share of right answers so much larger than the other one that no chance explains it, if both were answered by
/// the same work and questions are independent? Five standard deviations of the difference of two proportions.
[[nodiscard]] bool is_beyond_chance(const RightQuestions& larger, const RightQuestions& smaller);

}
