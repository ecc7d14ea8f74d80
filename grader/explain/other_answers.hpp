#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "explain/asked_answers.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

/// What both sides record of a check's case where another question is asked in place of its own.
struct OtherAnswers {
    OtherQuestion question;
    bool answered = false;  ///< both came to their end; only then is there anything in the two
    RunOutcome yours{};     ///< only what the check is about
    RunOutcome right{};
};

/// A run that was asked `count` other questions, as a run for each, with the names that the case records under.
[[nodiscard]] std::vector<RunOutcome> runs_of_others(const RunOutcome& run, std::size_t count);

/// What the reference takes for another question, about: a case of many calls takes far longer than by itself, since
/// each of them may have to be changed.
[[nodiscard]] double seconds_of_other(const RunOutcome& plain, const QuestionLog& log);

/// Asks the student's code and the reference these questions, with the inputs of a seed. Where one of the two does not
/// come to its end, each half by itself, until what it fails with is alone. Takes from `time`, and ends when it is up.
void ask_both(Worker& worker, const AskedCheck& asked, std::uint64_t seed, std::span<OtherAnswers> others,
              SpareTime& time);

}
