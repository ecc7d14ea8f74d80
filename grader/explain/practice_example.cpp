#include "explain/practice_example.hpp"

#include "explain/question_code.hpp"
#include "explain/samples.hpp"
#include "judge/judges.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_tried = 4;  ///< sets of practice inputs

/// The code behind a check's first wrong value.
std::string code_behind(Worker& worker, const AskedCheck& asked, const Difference& first, std::size_t cells,
                        std::uint64_t seed)
{
    const std::string& case_name = asked.check.case_name;
    QuestionSpan span;
    if (first.cell)
        span = worker.questions(asked.exercise, case_name, seed).questions_of(asked.check.value, *first.cell, cells);
    else if (const auto group = first_wrong_group(worker, asked, seed))
        span = {*group, 1};
    if (span.count == 0) return "";
    return together(span, worker.code_of(asked.exercise, case_name, seed, shown_of(span)));
}

}

std::optional<PracticeExample> practice_example(Worker& worker, const AskedCheck& asked)
{
    const Check& check = asked.check;
    if (check.relation || judge_of(check).look != Look::none) return std::nullopt;
    for (std::size_t place = 0; place < most_tried && worker.spare_time().is_left(); ++place) {
        const std::uint64_t seed = input_seed(asked, place);
        CaseResult one;
        one.seed = seed;
        one.student = asked.runs.plain(seed);
        if (!one.trouble().empty()) return std::nullopt;
        const RunOutcome& expected = worker.trusted(asked.exercise, judged_against(check), check.case_name, seed);
        const Tensor* const table = expected_of(check, expected).value;
        const CheckResult found = judge_check(check, one, expected, worker.basis(asked.exercise, check, seed));
        if (table == nullptr || found.score >= check.points || !found.first_difference) continue;
        PracticeExample example{*found.first_difference, seed};
        example.first.question = code_behind(worker, asked, example.first, table->cells(), seed);
        return example;
    }
    return std::nullopt;
}

}
