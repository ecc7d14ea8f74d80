#include "unit/right_questions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "judge/rows/rows.hpp"

namespace umbral::grader {

std::optional<RightQuestions> right_questions(Worker& worker, const Exercise& exercise, const Check& check,
                                              const CaseResult& one)
{
    const RunOutcome& run = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
    const Expected expected = expected_of(check, run);
    const Tensor* const student = tensor_of(one.student, check.value);
    if (!kept_from_judging(check, one, run).empty() || !has_single_rows(check, student, expected.value)) return {};
    const QuestionLog& log = worker.questions(exercise, check.case_name, one.seed);
    const auto asked = log.rows.find(check.value);
    const std::vector<RowState> rows = single_rows(check, *student, expected);
    if (asked == log.rows.end() || asked->second.size() != rows.size()) return {};
    std::map<std::uint32_t, bool> is_right;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (rows[row] == RowState::left_out) continue;
        bool& right = is_right.try_emplace(asked->second[row], true).first->second;
        right = right && rows[row] == RowState::right;
    }
    const auto right = std::ranges::count_if(is_right, [](const auto& question) { return question.second; });
    return RightQuestions{static_cast<std::size_t>(right), is_right.size()};
}

bool is_beyond_chance(const RightQuestions& larger, const RightQuestions& smaller)
{
    constexpr double deviations = 5;
    if (larger.all == 0 || smaller.all == 0) return false;
    const auto a = static_cast<double>(larger.all);
    const auto b = static_cast<double>(smaller.all);
    const double share = static_cast<double>(larger.right + smaller.right) / (a + b);
    const double difference = static_cast<double>(larger.right) / a - static_cast<double>(smaller.right) / b;
    return difference > deviations * std::sqrt(share * (1 - share) * (1 / a + 1 / b));
}

}
