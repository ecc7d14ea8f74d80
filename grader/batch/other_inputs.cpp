#include "batch/other_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "batch/fixed_inputs.hpp"
#include "batch/student_case.hpp"
#include "judge/judges.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

/// Inputs that are tried one after the other. By chance alone none of two fails that should not.
constexpr unsigned most_rounds = 2;
/// What is earned with other inputs differs a little for work that is partly right: less than half of it, and a tenth
/// of the check's points less, is more than that.
constexpr Millipoints least_part = 2;
constexpr Millipoints least_loss = 10;

bool holds(const CheckResult& before, Millipoints with_other_inputs)
{
    return least_part * with_other_inputs >= before.score ||
           least_loss * (before.score - with_other_inputs) < before.max_score;
}

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
        if (holds(result.checks[i], 0) || judge_of(check).counts_work || is_hidden_case(exercise, check.case_name))
            continue;
        if (has_other_inputs(worker, exercise, check, options.seeds))
            earners.asked.push_back({i});
        else
            earners.unchanging.push_back(i);
    }
    return earners;
}

void ask_once(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
              const GradeOptions& options, unsigned round, const UnitResult& result, std::vector<Asked>& asked)
{
    CaseResults again;
    for (Asked& one : asked) {
        if (one.held) continue;
        const Check& check = exercise.checks[one.check];
        const CheckResult& before = result.checks[one.check];
        const std::uint64_t seed = options.seeds.other_seed_of(exercise, check.case_name, round);
        if (!again.contains(check.case_name))
            again.emplace(check.case_name, may_run_another(again)
                                               ? run_case(worker, exercise, built, check.case_name, seed, false)
                                               : not_reached(seed, false));
        const Millipoints now =
            earned(worker, exercise, check, again.at(check.case_name), before, cases.at(check.case_name).seed);
        one.best = std::max(one.best, now);
        one.held = holds(before, one.best);
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

void expect_the_same_of_other_inputs(Worker& worker, const Exercise& exercise, const Built& built,
                                     const CaseResults& cases, const GradeOptions& options, UnitResult& result)
{
    Earners earners = earners_of(worker, exercise, options, result);
    std::vector<Asked>& asked = earners.asked;
    const auto all_held = [&] { return std::ranges::all_of(asked, &Asked::held); };
    for (unsigned round = 0; round < most_rounds && !all_held(); ++round)
        ask_once(worker, exercise, built, cases, options, round, result, asked);
    if (all_held()) return;
    Millipoints before = 0;
    Millipoints now = 0;
    for (const Asked& one : asked) {
        CheckResult& found = result.checks[one.check];
        before += found.score;
        now += one.held ? found.score : one.best;
        if (!one.held) take_away(found, one.best, "not with others");
    }
    // Who wrote down most of the answers that could be told apart is not believed about the others.
    if (least_part * now >= before) return;
    for (const std::size_t i : earners.unchanging)
        take_away(result.checks[i], result.checks[i].score * now / before, "these never change, while others failed");
}

}
