#include "explain/explained_checks.hpp"

#include <algorithm>
#include <tuple>

#include "judge/explain/thresholds.hpp"
#include "worker/past_crashes.hpp"
#include "worker/related.hpp"
#include "worker/weigh_cost.hpp"

namespace umbral::grader {
namespace {

/// Are all rows of this check answers of functions that are written, in a case that asks others too?
bool is_written(const Check& check, const CaseResult& one)
{
    const Tensor* recorded = one.past ? tensor_of(*one.past, check.value) : nullptr;
    return !check.relation && recorded != nullptr && recorded->columns == 1 &&
           rows_without_answers(check, *one.past).empty();
}

}

std::vector<CaseChecks> checks_by_case(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                       const CaseResults& cases, std::list<Check>& plain)
{
    std::vector<CaseChecks> groups;
    for (const std::string& name : exercise.cases()) groups.push_back({name, &cases.at(name), {}, 0, 0});
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& declared = exercise.checks[i];
        CaseChecks& group = *std::ranges::find(groups, declared.case_name, &CaseChecks::name);
        // Code that is not written yet says nothing about code that is.
        const bool unwritten = group.result->is_stub() && !is_written(declared, *group.result);
        if (unwritten || !group.result->reached || group.result->beside) continue;
        const bool fails = result.checks[i].score < declared.points;
        if (declared.relation && !fails) continue;
        const RunOutcome& expected =
            worker.trusted(exercise, judged_against(declared), declared.case_name, group.result->seed);
        const auto shown = [&]() -> const Check& {
            if (declared.relation)
                return plain.emplace_back(against_reference(declared, group.result->student, expected));
            auto answers = fails ? check_of_answers(declared, group.result->student, expected) : std::nullopt;
            return answers ? plain.emplace_back(std::move(*answers)) : declared;
        };
        const Check& check = shown();
        const Expected side = expected_of(check, expected);
        const Tensor* const yours = observed_beginning(check, group.result->student);
        group.checks.push_back({&check, yours, side.value, side.margin, fails});
        group.failing += fails ? 1 : 0;
        if (side.value != nullptr) group.cells += side.value->cells();
    }
    std::erase_if(groups, [](const CaseChecks& group) { return group.checks.empty(); });
    // Never by time: which mistakes are left out early depends on the order, and two gradings must agree. But hard
    // cases as a rule take longer than others.
    std::ranges::stable_sort(groups, {}, [](const CaseChecks& group) {
        const bool hard = std::ranges::any_of(group.checks, [](const FailingCheck& one) { return one.check->hard; });
        return std::tuple(group.failing == 0, hard, group.cells, group.name);
    });
    return groups;
}

Resemblance says_of(const FailingCheck& one, const CaseResult& yours, const RunOutcome& its)
{
    if (yours.student.verdict != its.verdict) return not_alike;
    if (its.verdict != Verdict::ok) return {};
    const Tensor* tensor = observed_beginning(*one.check, its);
    if (tensor == nullptr) return one.student == nullptr ? Resemblance{} : not_alike;
    return one.student == nullptr ? not_alike : resemblance(one, *tensor);
}

bool explains_all(const Explanation& one)
{
    return !one.hidden && one.fit == 1 && one.confidence >= thresholds::very_sure;
}

bool is_explained(const UnitResult& result)
{
    return std::ranges::any_of(result.explanations, [](const Explanation& one) {
        return one.name.starts_with("mistake: ") && explains_all(one);
    });
}

}
