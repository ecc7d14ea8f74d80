#pragma once

#include <optional>
#include <string>

#include "batch/case_results.hpp"
#include "batch/worker.hpp"
#include "build/submission.hpp"
#include "question/conditions.hpp"
#include "question/log.hpp"

namespace umbral::grader {

/// One failing check, and the questions of its case.
struct AskedCheck {
    const Exercise& exercise;
    const Check& check;
    const Built& built;
    const CaseResult& result;
    const QuestionLog& log;
    const std::string& headers;  ///< the text of the unit's interface headers, where its parameters have names
};

/// The simplest condition that parts wrong answers from right ones, if it does so on fresh inputs too, or if there can
/// be no others. Nothing of hidden cases, whose student's code is not run again.
[[nodiscard]] std::optional<Condition> find_common_condition(Worker& worker, const AskedCheck& asked);

/// The same in words: "wrong wherever ray.t_min is positive (50 of 50), right everywhere else (350 of 350)"; empty if
/// there is none.
[[nodiscard]] std::string common_condition(Worker& worker, const AskedCheck& asked);

/// Does the condition part wrong answers from right ones with the inputs of this seed too? Nothing if that cannot be
/// said, as where none or all are wrong there.
[[nodiscard]] std::optional<bool> holds_at(Worker& worker, const AskedCheck& asked, const Condition& condition,
                                           std::uint64_t seed);

}
