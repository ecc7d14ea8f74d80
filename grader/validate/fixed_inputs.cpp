#include "validate/fixed_inputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "judge/judges.hpp"
#include "unit/other_inputs.hpp"
#include "validate/known_questions.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {
namespace {

/// Percent of a unit's points. Some hard cases are what they are: a zero, a degenerate triangle, one pixel's corner.
constexpr double most_fixed = 30;

/// What is left of a check's points for the reference's answers to one seed's inputs, judged with another's.
Millipoints kept(Worker& worker, const Exercise& exercise, const Check& check, const SeedPlan& seeds)
{
    const std::string& name = check.case_name;
    const auto [seed, other] = seeds.two_seeds_of(exercise, name);
    CaseResult one;
    one.seed = seed;
    one.student = worker.trusted(exercise, Answers::reference, name, seed);
    const RunOutcome& expected = worker.trusted(exercise, judged_against(check), name, other);
    const CheckResult found = judge_check(check, one, expected, worker.basis(exercise, check, seed));
    return believed_part * found.score >= found.max_score ? found.max_score : found.score;
}

}

Finding expect_few_fixed_inputs(Worker& worker, const Exercise& exercise, const SeedPlan& seeds, unsigned seed,
                                Tables tables)
{
    std::vector<std::string> fixed;
    Millipoints points = 0;
    for (const Check& check : exercise.checks) {
        Millipoints left = judge_of(check).counts_work ? 0 : kept(worker, exercise, check, seeds);
        if (tables == Tables::tried) {
            const double share = known_share(worker, exercise, check, seeds);
            left = std::max(left, static_cast<Millipoints>(share * static_cast<double>(check.points)));
        }
        points += left;
        if (left > 0) fixed.push_back(check.name);
    }
    Finding finding{exercise.id, "fixed inputs", seed, false, 0, fmt::format("0..{:g}", most_fixed), ""};
    finding.credit = 100.0 * static_cast<double>(points) / static_cast<double>(exercise.points);
    finding.holds = finding.credit <= most_fixed;
    if (!fixed.empty())
        finding.message = fmt::format(
            "right answers to some seeds' inputs earn points with another's: {}{}", fmt::join(fixed, ", "),
            finding.holds ? "" : "; let the driver vary what is written there (c.vary), over more than a few values");
    return finding;
}

}
