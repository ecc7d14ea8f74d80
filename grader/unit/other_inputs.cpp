#include "unit/other_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "judge/judges.hpp"
#include "report/paint.hpp"
#include "unit/right_questions.hpp"
#include "worker/student_case.hpp"

namespace umbral::grader {
namespace {

/// Inputs that are tried one after the other. By chance alone none of two fails that should not.
constexpr unsigned most_rounds = 2;
/// What is earned with other inputs differs a little for work that is partly right: a tenth of the check's points less
/// is more than that if it had earned more than nine tenths of them, if it is less than half of what was earned
/// (believed_part), or if fewer questions were answered rightly than by chance.
constexpr Millipoints least_loss = 10;

bool is_little(const CheckResult& before, Millipoints lost) { return least_loss * lost < before.max_score; }

/// What a check earns with other inputs. One that another run would have to decide has earned what it did before.
Millipoints earned(Worker& worker, const Exercise& exercise, const Check& check, const CaseResult& one,
                   const CheckResult& before, std::uint64_t first_seed)
{
    const RunOutcome& expected = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
    // The control is a property of the case: what it gets was worked out for the first seed.
    const CheckResult found = judge_check(check, one, expected, worker.basis(exercise, check, first_seed));
    return found.borderline ? before.score : found.score;
}

/// A check, and the most that it earned with other inputs.
struct Asked {
    std::size_t check = 0;
    Millipoints best = 0;
    bool held = false;
    std::optional<RightQuestions> before{};  ///< counted where it is needed
};

/// Visible checks that earned enough to be doubted: those with other inputs, and those whose inputs never change.
struct Earners {
    std::vector<Asked> asked;
    std::vector<std::size_t> unchanging;
};

Earners earners_of(Worker& worker, const Exercise& exercise, const GradeOptions& options, const UnitResult& result)
{
    Earners earners;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        if (is_little(result.checks[i], result.checks[i].score) || is_hidden_case(exercise, check.case_name)) continue;
        if (has_other_inputs(worker, exercise, check, options.seeds))
            earners.asked.push_back({i});
        else
            earners.unchanging.push_back(i);
    }
    return earners;
}

/// Is what was earned with other inputs no less than work that is what it seems earns there?
bool holds(Worker& worker, const Exercise& exercise, const Check& check, const CheckResult& before,
           const CaseResult& first, const CaseResult& other, Asked& asked)
{
    if (is_little(before, before.score - asked.best)) return true;
    // How work grows is fitted to a few sizes, and what little differs may cost points; wrong answers cost all.
    if (judge_of(check).counts_work) return believed_part * asked.best >= before.score;
    // Where work seemed right in nearly all, two others of a case's inputs tell more than everybody's.
    const bool seemed_right = is_little(before, before.max_score - before.score);
    if (seemed_right || believed_part * asked.best < before.score) return false;
    if (!asked.before) asked.before = right_questions(worker, exercise, check, first);
    const auto now = right_questions(worker, exercise, check, other);
    return !asked.before || !now || !is_beyond_chance(*asked.before, *now);
}

/// `again` holds what the rounds before came to: all of them have the time that the unit's cases have once.
void ask_once(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
              const GradeOptions& options, unsigned round, const UnitResult& result, std::vector<Asked>& asked,
              CaseResults& again)
{
    for (Asked& one : asked) {
        if (one.held) continue;
        const Check& check = exercise.checks[one.check];
        const CheckResult& before = result.checks[one.check];
        const std::uint64_t seed = options.seeds.other_seed_of(exercise, check.case_name, round);
        const std::string in_round = fmt::format("{} {}", round, check.case_name);
        if (!again.contains(in_round))
            again.emplace(in_round, may_run_another(worker.budget(), again, exercise.limits)
                                        ? run_case(worker, exercise, built, check.case_name, seed, false)
                                        : not_reached(seed, false));
        const CaseResult& first = cases.at(check.case_name);
        const CaseResult& other = again.at(in_round);
        one.best = std::max(one.best, earned(worker, exercise, check, other, before, first.seed));
        one.held = holds(worker, exercise, check, before, first, other, one);
    }
}

void take_away(CheckResult& found, Millipoints left, std::string_view why)
{
    found.message += fmt::format("{}{} of {} points with the inputs that everybody has, and {}: {} count",
                                 found.message.empty() ? "" : "; ", points_text(found.score),
                                 points_text(found.max_score), why, points_text(left));
    found.score = left;
}

}

bool has_other_inputs(Worker& worker, const Exercise& exercise, const Check& check, const SeedPlan& seeds)
{
    const auto [seed, other] = seeds.two_seeds_of(exercise, check.case_name);
    const RunOutcome& first = worker.trusted(exercise, Answers::reference, check.case_name, seed);
    const RunOutcome& second = worker.trusted(exercise, Answers::reference, check.case_name, other);
    return std::ranges::any_of(values_of(check), [&](const std::string& value) {
        const Tensor* a = tensor_of(first, value);
        const Tensor* b = tensor_of(second, value);
        return a == nullptr || b == nullptr ? a != b : !(*a == *b);
    });
}

void expect_the_same_of_other_inputs(Worker& worker, const Exercise& exercise, const Built& built,
                                     const CaseResults& cases, const GradeOptions& options, UnitResult& result)
{
    Earners earners = earners_of(worker, exercise, options, result);
    std::vector<Asked>& asked = earners.asked;
    const auto all_held = [&] { return std::ranges::all_of(asked, &Asked::held); };
    CaseResults again;
    for (unsigned round = 0; round < most_rounds && !all_held(); ++round)
        ask_once(worker, exercise, built, cases, options, round, result, asked, again);
    if (all_held()) return;
    Millipoints before = 0;
    Millipoints now = 0;
    for (const Asked& one : asked) {
        CheckResult& found = result.checks[one.check];
        before += found.score;
        now += one.held ? found.score : one.best;
        if (one.held) continue;
        take_away(found, one.best, "not with others");
        found.message += " (umbral check --attempt 1, 2, ... asks others)";
    }
    // Who wrote down most of the answers that could be told apart is not believed about the others.
    if (believed_part * now >= before) return;
    for (const std::size_t i : earners.unchanging)
        take_away(result.checks[i], result.checks[i].score * now / before, "these never change, while others failed");
}

}
