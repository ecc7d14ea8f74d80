#include "batch/simplest_question.hpp"

#include <algorithm>

#include "judge/explain/resemblances.hpp"
#include "judge/judges.hpp"
#include "judge/rows/rows.hpp"
#include "judge/rules.hpp"
#include "question/log.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_checks = 2;   ///< for which it is looked for: those that are shown first
constexpr std::size_t most_wrong = 200;  ///< rows of one run whose questions are compared
constexpr double much_shorter = 0.75;    ///< of the first question's length

/// From coarse to fine: the first at which the work is still wrong has the simplest inputs.
constexpr Grain grains[] = {{1, 0}, {2, 0}, {2, 2}, {3, 0}, {4, 0}, {4, 4}, {6, 0}};

struct Simplest {
    std::optional<Difference> found;

    void offer(const Difference& other)
    {
        if (!found || other.question.size() < found->question.size()) found = other;
    }
};

/// The wrong rows of one run, each with its question.
void look_at(Worker& worker, const Exercise& exercise, const Built& built, const Check& declared, const CaseResult& one,
             const Grain& grain, Simplest& simplest)
{
    const auto told = worker.run_coarse(exercise, Answers::reference, declared.case_name, one.seed, grain);
    if (told.verdict != Verdict::ok) return;
    const RunOutcome expected =
        declared.hard ? worker.run_coarse(exercise, Answers::oracle, declared.case_name, one.seed, grain) : told;
    if (expected.verdict != Verdict::ok) return;
    const RunOutcome student = worker.run_coarse(exercise, built, declared.case_name, one.seed, grain, expected);
    const Expected side = expected_of(declared, expected);
    const Tensor* yours = observed(declared, student);
    if (student.verdict != Verdict::ok || yours == nullptr || side.value == nullptr || !well_formed(*yours) ||
        !well_formed(*side.value) || shape_error(declared, *yours, *side.value))
        return;
    Check check = declared;
    check.pairs = false;
    const QuestionLog log = read_questions(told.recording.tensors);
    const std::vector<RowState> states = row_states(check, *yours, *side.value, side.margin, rows_of(check));
    std::map<std::uint32_t, std::size_t> rows;
    for (std::size_t row = 0; row < states.size() && rows.size() < most_wrong; ++row)
        if (const auto question = log.question_of(check.value, row, states.size());
            states[row] == RowState::wrong && question)
            rows.emplace(*question, row);
    if (rows.empty()) return;
    Inquiry inquiry{.grain = grain};
    for (const auto& [question, row] : rows) inquiry.wanted.push_back(question);
    const RunOutcome written = worker.inquire(exercise, declared.case_name, one.seed, inquiry);
    if (written.verdict != Verdict::ok) return;
    const RowKind& kind = rows_of(check);
    const TensorView view(*yours);
    const TensorView right(*side.value);
    for (const auto& [question, code] : read_questions(written.recording.tensors).code) {
        const auto found = rows.find(question);
        if (found == rows.end()) continue;
        const auto [mine, reference] = show_both(kind, view, right, found->second, 0);
        simplest.offer({"simpler inputs", mine, reference, std::nullopt, code});
    }
}

bool can_be_simpler(const Check& check, const CheckResult& result)
{
    const JudgeRecord& judge = judge_of(check);
    return result.score < check.points && !check.hidden && !check.relation && !judge.free_rows && judge.plain_values &&
           judge.look == Look::none && result.first_difference && !result.first_difference->question.empty();
}

}

void add_simplest_question(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                           UnitResult& result)
{
    std::vector<std::size_t> checks;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i)
        if (can_be_simpler(exercise.checks[i], result.checks[i])) checks.push_back(i);
    std::ranges::stable_sort(checks, {}, [&](std::size_t i) { return judge_of(exercise.checks[i]).place; });
    if (checks.size() > most_checks) checks.resize(most_checks);
    for (const std::size_t i : checks) {
        const Check& check = exercise.checks[i];
        Simplest simplest;
        for (const Grain& grain : grains)
            look_at(worker, exercise, built, check, cases.at(check.case_name), grain, simplest);
        const std::size_t first = result.checks[i].first_difference->question.size();
        if (simplest.found &&
            static_cast<double>(simplest.found->question.size()) < much_shorter * static_cast<double>(first))
            result.checks[i].simplest = std::move(simplest.found);
    }
}

}
