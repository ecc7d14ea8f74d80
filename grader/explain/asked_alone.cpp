#include "explain/asked_alone.hpp"

#include <algorithm>

#include "explain/some_rows.hpp"
#include "judge/judges.hpp"
#include "judge/rows/rows.hpp"
#include "worker/past_crashes.hpp"

namespace umbral::grader {
namespace {

using RowNumbers = std::vector<std::size_t>;

RowNumbers rows_of(const QuestionLog& log, const std::string& value, std::uint32_t question)
{
    RowNumbers rows;
    const auto found = log.rows.find(value);
    if (found == log.rows.end()) return rows;
    for (std::size_t row = 0; row < found->second.size(); ++row)
        if (found->second[row] == question + 1) rows.push_back(row);
    return rows;
}

/// The rows of a run's table that do not stand for an answer that nobody gave.
RowNumbers answered_rows(const Check& check, const RunOutcome& run, const Tensor& recorded)
{
    std::vector<std::uint32_t> lost = rows_without_answers(check, run);
    std::ranges::sort(lost);
    RowNumbers rows;
    for (std::uint32_t row = 0; row < recorded.rows; ++row)
        if (!std::ranges::binary_search(lost, row)) rows.push_back(row);
    return rows;
}

/// Is nothing what is to be found, and what was?
bool is_nothing_right(const Check& check, const RunOutcome& run)
{
    const Tensor* const recorded = tensor_of(run, check.value);
    return !check.relation && judge_of(check).plain_values && recorded != nullptr && well_formed(*recorded) &&
           answered_rows(check, run, *recorded).empty();
}

/// The rows that a run recorded for its only question beside those that the question has where all is asked. They stand
/// elsewhere: who is not asked for a list gives none, and what stands behind it moves up.
bool is_answer_right(const Check& check, const RunOutcome& run, const Expected& expected, const RowNumbers& places)
{
    const Tensor* recorded = tensor_of(run, check.value);
    const Tensor& right = *expected.value;
    if (check.relation || !judge_of(check).plain_values || recorded == nullptr || recorded->columns != 1 ||
        right.columns != 1 || places.back() >= right.rows || !well_formed(*recorded) || !well_formed(right) ||
        row_shape_error(*recorded, right))
        return false;
    const RowNumbers answered = answered_rows(check, run, *recorded);
    if (answered.empty()) return false;
    const Tensor yours = some_rows(*recorded, answered);
    const Tensor wanted = some_rows(right, places);
    const bool has_margin = expected.margin != nullptr && well_formed(*expected.margin) &&
                            expected.margin->rows == right.rows && expected.margin->columns == 1;
    const Tensor margin = has_margin ? some_rows(*expected.margin, places) : Tensor();
    Check alone = check;
    alone.pairs = false;
    if (judge_of(check).free_rows) return judge(alone, yours, wanted, has_margin ? &margin : nullptr).right >= 1;
    const Expected side{&wanted, has_margin ? &margin : nullptr, expected.names};
    if (answered.size() != places.size() || !has_single_rows(alone, &yours, &wanted)) return false;
    return std::ranges::none_of(single_rows(alone, yours, side),
                                [](RowState state) { return state == RowState::wrong; });
}

}

bool is_row_right(const Check& check, const RunOutcome& run, const Expected& expected, const AskedRow& asked)
{
    if (run.verdict != Verdict::ok || expected.value == nullptr) return false;
    if (const RowNumbers places = rows_of(asked.log, check.value, asked.question); !places.empty())
        return is_answer_right(check, run, expected, places);
    if (asked.log.rows.contains(check.value)) return is_nothing_right(check, run);
    CaseResult alone;
    alone.past = run;
    const auto answers = answers_past_crashes(check, alone, *expected.value);
    if (!answers) return false;
    const std::vector<RowState> states = single_rows(check, answers->tensor, expected);
    return asked.row < states.size() && states[asked.row] == RowState::right;
}

bool is_right_alone(Worker& worker, const Exercise& exercise, const Built& built, const Check& check,
                    const CaseResult& one, std::uint32_t question, std::size_t row)
{
    const RunOutcome alone =
        worker.run_past(exercise, built, check.case_name, one.seed, only(question), exercise.limits.wall_seconds);
    const RunOutcome& whole = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
    const AskedRow asked{worker.questions(exercise, check.case_name, one.seed), question, row};
    if (!is_row_right(check, alone, expected_of(check, whole), asked)) return false;
    // A question whose arguments follow from answers before it is another one without these.
    const RunOutcome right =
        worker.trusted_past(exercise, judged_against(check), check.case_name, one.seed, only(question));
    return is_row_right(check, right, expected_of(check, whole), asked);
}

}
