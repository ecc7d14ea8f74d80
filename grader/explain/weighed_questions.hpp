#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "explain/explained_checks.hpp"
#include "judge/explain/confidence.hpp"
#include "question/log.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

/// A question that may be the one that was answered, and what checks say of it.
struct WeighedQuestion {
    OtherQuestion question;
    Tally tally{};
    std::size_t failing = 0;              ///< checks in which its function was asked
    bool fits = false;                    ///< a failing check of the case looked at speaks for it
    std::vector<std::string> speaking{};  ///< the failing checks that speak for it
};

/// May the question change what the check holds? Not if all its rows are known to be answers that it does not change.
[[nodiscard]] bool may_concern(const QuestionLog& log, const FailingCheck& one, std::span<const std::string> functions);

/// How many other questions one run of this case can be asked: what it can hold, and within a fifth of its time, which
/// a busy machine stretches. One where it draws by OpenGL.
[[nodiscard]] std::size_t questions_of_a_run(const Exercise& exercise, const RunOutcome& plain);

/// Asks one case each of the questions, as many as a run can hold at a time. Where a run does not end well, its
/// questions are asked in halves, until the one that does not bear asking is alone: some never end, such as a vector
/// without length.
void weigh_all(Worker& worker, const Exercise& exercise, const CaseChecks& group, std::span<WeighedQuestion> candidates,
               SpareTime& time);

}
