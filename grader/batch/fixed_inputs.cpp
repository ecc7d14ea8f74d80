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

}

bool has_other_inputs(Worker& worker, const Exercise& exercise, const Check& check, const SeedPlan& seeds)
{
    const std::string& name = check.case_name;
    const std::uint64_t other =
        is_hidden_case(exercise, name) ? seeds.fresh_seed_of(exercise, name) : seeds.public_seed_of(exercise, name);
    const RunOutcome& one = worker.trusted(exercise, Answers::reference, name, seeds.seed_of(exercise, name));
    const RunOutcome& two = worker.trusted(exercise, Answers::reference, name, other);
    return std::ranges::any_of(values_of(check), [&](const std::string& value) {
        const Tensor* a = tensor_of(one, value);
        const Tensor* b = tensor_of(two, value);
        return a == nullptr || b == nullptr ? a != b : !(*a == *b);
    });
}

Finding expect_few_fixed_inputs(Worker& worker, const Exercise& exercise, const SeedPlan& seeds, unsigned seed)
{
    std::vector<std::string> fixed;
    Millipoints points = 0;
    for (const Check& check : exercise.checks) {
        if (judge_of(check).counts_work || has_other_inputs(worker, exercise, check, seeds)) continue;
        points += check.points;
        fixed.push_back(check.name);
    }
    Finding finding{exercise.id, "fixed inputs", seed, false, 0, fmt::format("0..{:g}", most_fixed), ""};
    finding.credit = 100.0 * static_cast<double>(points) / static_cast<double>(exercise.points);
    finding.holds = finding.credit <= most_fixed;
    if (!fixed.empty())
        finding.message = fmt::format("the same answers whatever the seed: {}{}", fmt::join(fixed, ", "),
                                      finding.holds ? "" : "; let the driver vary what is written there (c.vary)");
    return finding;
}

}
