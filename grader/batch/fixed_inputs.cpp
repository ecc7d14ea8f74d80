#include "batch/fixed_inputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "batch/case_results.hpp"
#include "judge/judges.hpp"

namespace umbral::grader {
namespace {

/// Percent of a unit's points. Some hard cases are what they are: a zero, a degenerate triangle, one pixel's corner.
constexpr double most_fixed = 30;

struct TwoSeeds {
    std::uint64_t one;
    std::uint64_t other;
};

TwoSeeds two_seeds(const Exercise& exercise, const std::string& case_name, const SeedPlan& seeds)
{
    return {seeds.seed_of(exercise, case_name), is_hidden_case(exercise, case_name)
                                                    ? seeds.fresh_seed_of(exercise, case_name)
                                                    : seeds.public_seed_of(exercise, case_name)};
}

/// What is left of a check's points for the reference's answers to one seed's inputs, judged with another's.
Millipoints kept(Worker& worker, const Exercise& exercise, const Check& check, const SeedPlan& seeds)
{
    const std::string& name = check.case_name;
    const auto [seed, other] = two_seeds(exercise, name, seeds);
    CaseResult one;
    one.seed = seed;
    one.student = worker.trusted(exercise, Answers::reference, name, seed);
    const RunOutcome& expected = worker.trusted(exercise, judged_against(check), name, other);
    const CheckResult found = judge_check(check, one, expected, worker.basis(exercise, check, seed));
    return believed_part * found.score >= found.max_score ? found.max_score : found.score;
}

}

bool has_other_inputs(Worker& worker, const Exercise& exercise, const Check& check, const SeedPlan& seeds)
{
    const auto [seed, other] = two_seeds(exercise, check.case_name, seeds);
    const RunOutcome& first = worker.trusted(exercise, Answers::reference, check.case_name, seed);
    const RunOutcome& second = worker.trusted(exercise, Answers::reference, check.case_name, other);
    return std::ranges::any_of(values_of(check), [&](const std::string& value) {
        const Tensor* a = tensor_of(first, value);
        const Tensor* b = tensor_of(second, value);
        return a == nullptr || b == nullptr ? a != b : !(*a == *b);
    });
}

Finding expect_few_fixed_inputs(Worker& worker, const Exercise& exercise, const SeedPlan& seeds, unsigned seed)
{
    std::vector<std::string> fixed;
    Millipoints points = 0;
    for (const Check& check : exercise.checks) {
        const Millipoints left = judge_of(check).counts_work ? 0 : kept(worker, exercise, check, seeds);
        points += left;
        if (left > 0) fixed.push_back(check.name);
    }
    Finding finding{exercise.id, "fixed inputs", seed, false, 0, fmt::format("0..{:g}", most_fixed), ""};
    finding.credit = 100.0 * static_cast<double>(points) / static_cast<double>(exercise.points);
    finding.holds = finding.credit <= most_fixed;
    if (!fixed.empty())
        finding.message =
            fmt::format("right answers to one seed's inputs earn points with another's: {}{}", fmt::join(fixed, ", "),
                        finding.holds ? "" : "; let the driver vary what is written there (c.vary)");
    return finding;
}

}
