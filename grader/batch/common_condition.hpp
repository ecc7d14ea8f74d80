#pragma once

#include <string>
#include <vector>

#include "batch/case_results.hpp"
#include "batch/worker.hpp"
#include "build/submission.hpp"
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

/// "wrong wherever ray.t_min is positive (50 of 50), right everywhere else (350 of 350)": the simplest condition that
/// parts wrong answers from right ones, if it does so on fresh inputs too, or if there can be no others. Empty if there
/// is none; of hidden cases too, whose student's code is not run again.
[[nodiscard]] std::string common_condition(Worker& worker, const AskedCheck& asked);

}
