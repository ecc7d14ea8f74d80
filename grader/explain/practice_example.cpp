#include "explain/practice_example.hpp"

#include "explain/asked_alone.hpp"
#include "explain/question_code.hpp"
#include "judge/judges.hpp"
#include "worker/seeds.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_tried = 4;  ///< sets of practice inputs
constexpr std::size_t most_drawn = 2;  ///< of a picture, which takes longer and is mostly wrong everywhere

/// A run that fails a check, and what was found.
struct Wrong {
    CaseResult one;
    CheckResult found;
};

/// The first of a few runs with practice inputs that fails the check; none if one does not run to its end.
template <class Run>
std::optional<Wrong> first_wrong(Worker& worker, const Exercise& exercise, const Check& check, std::size_t most,
                                 const Run& run)
{
    for (std::size_t place = 0; place < most && worker.spare_time().is_left(); ++place) {
        CaseResult one;
        one.seed = practice_seed(exercise, check.case_name, place);
        one.student = run(one.seed);
        if (!one.cause().empty()) return std::nullopt;
        const RunOutcome& expected = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
        CheckResult found = judge_check(check, one, expected, worker.basis(exercise, check, one.seed));
        if (found.score < check.points) return Wrong{std::move(one), std::move(found)};
    }
    return std::nullopt;
}

/// The code behind a check's first wrong value.
std::string code_behind(Worker& worker, const AskedCheck& asked, const Difference& first, std::size_t cells,
                        std::uint64_t seed)
{
    const std::string& case_name = asked.check.case_name;
    QuestionSpan span;
    if (first.cell)
        span = worker.questions(asked.exercise, case_name, seed).questions_of(asked.check.value, *first.cell, cells);
    if (span.count == 0) return "";
    return together(span, worker.code_of(asked.exercise, case_name, seed, shown_of(span)));
}

}

std::optional<PracticeExample> practice_example(Worker& worker, const AskedCheck& asked)
{
    const Check& check = asked.check;
    if (check.relation || judge_of(check).look != Look::none) return std::nullopt;
    const auto run = [&](std::uint64_t seed) { return asked.runs.plain(seed); };
    const auto wrong = first_wrong(worker, asked.exercise, check, most_tried, run);
    if (!wrong) return std::nullopt;
    const std::uint64_t seed = wrong->one.seed;
    const std::optional<Difference>& first = wrong->found.first_difference;
    if (const auto group = first_wrong_group(worker, asked, seed); group && (group->first || (first && !first->cell))) {
        PracticeExample example{group->first ? *group->first : *first, seed};
        example.first.question =
            together({group->question, 1}, worker.code_of(asked.exercise, check.case_name, seed, {group->question}));
        return example;
    }
    if (!first) return std::nullopt;
    const RunOutcome& expected = worker.trusted(asked.exercise, judged_against(check), check.case_name, seed);
    const Tensor* const table = expected_of(check, expected).value;
    PracticeExample example{*first, seed};
    if (table != nullptr) example.first.question = code_behind(worker, asked, example.first, table->cells(), seed);
    return example;
}

CaseResults practice_pictures(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                              const UnitResult& result)
{
    CaseResults found;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        const CaseResult& one = cases.at(check.case_name);
        if (!check.hidden || !is_picture(check) || result.checks[i].score >= check.points || !one.cause().empty() ||
            found.contains(check.case_name) || !may_repeat(worker, exercise, one))
            continue;
        const auto run = [&](std::uint64_t seed) { return worker.run_again(exercise, built, check.case_name, seed); };
        if (auto wrong = first_wrong(worker, exercise, check, most_drawn, run))
            found.emplace(check.case_name, std::move(wrong->one));
    }
    return found;
}

}
