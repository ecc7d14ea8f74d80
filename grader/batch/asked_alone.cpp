#include "batch/asked_alone.hpp"

#include "batch/past_crashes.hpp"
#include "judge/judges.hpp"

namespace umbral::grader {

bool is_row_right(const Check& check, const RunOutcome& run, const Expected& expected, std::size_t row)
{
    if (run.verdict != Verdict::ok || expected.value == nullptr) return false;
    CaseResult alone;
    alone.past = run;
    const auto answers = answers_past_crashes(check, alone, *expected.value);
    if (!answers) return false;
    const std::vector<RowState> states = single_rows(check, answers->tensor, expected);
    return row < states.size() && states[row] == RowState::right;
}

bool is_right_alone(Worker& worker, const Exercise& exercise, const Built& built, const Check& check,
                    const CaseResult& one, std::uint32_t question, std::size_t row)
{
    const RunOutcome alone = worker.run_past(exercise, built, check.case_name, one.seed, only(question));
    const RunOutcome& whole = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
    return is_row_right(check, alone, expected_of(check, whole), row);
}

}
