#include "batch/asked_alone.hpp"

#include "batch/past_crashes.hpp"
#include "judge/judges.hpp"

namespace umbral::grader {

bool is_right_alone(Worker& worker, const Exercise& exercise, const Built& built, const Check& check,
                    const CaseResult& one, std::uint32_t question, std::size_t row)
{
    CaseResult alone = one;
    alone.past = worker.run_past(exercise, built, check.case_name, one.seed, {.end = question + 1, .only = question});
    if (alone.past->verdict != Verdict::ok) return false;
    const Expected expected =
        expected_of(check, worker.trusted(exercise, judged_against(check), check.case_name, one.seed));
    if (expected.value == nullptr) return false;
    const auto answers = answers_past_crashes(check, alone, *expected.value);
    if (!answers) return false;
    const std::vector<RowState> states = single_rows(check, answers->tensor, expected);
    return row < states.size() && states[row] == RowState::right;
}

}
