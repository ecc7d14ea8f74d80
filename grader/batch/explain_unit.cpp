#include "batch/explain_unit.hpp"

#include <algorithm>
#include <map>

#include "batch/specimens.hpp"
#include "judge/explain.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_explanations = 3;

/// The failing checks that could be judged at all: a crash needs no signature.
std::vector<FailingCheck> failing_checks(Workshop& workshop, const Exercise& exercise, const UnitResult& result, const CaseResults& cases)
{
    std::vector<FailingCheck> failing;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        const CaseResult& one = cases.at(check.case_name);
        if (result.checks[i].score == check.points || !one.trouble().empty()) continue;
        const RunOutcome& expected = workshop.trusted(exercise, check.hard ? Tenant::oracle : Tenant::reference, check.case_name, one.seed);
        const Tensor* student = tensor_of(one.student, check.value);
        if (student == nullptr) continue;
        failing.push_back({&check, student, tensor_of(expected, check.value), tensor_of(expected, check.value + ".margin"), nullptr});
    }
    return failing;
}

std::vector<Explanation> by_mistakes(Workshop& workshop, const Exercise& exercise, const std::vector<FailingCheck>& failing, const CaseResults& cases)
{
    std::vector<Explanation> found;
    for (const Specimen& mistake : mistakes_of(workshop.tools().reference, exercise)) {
        if (mistake.verdict && *mistake.verdict != Verdict::wrong && *mistake.verdict != Verdict::partial) continue;
        std::size_t matching = 0;
        for (const FailingCheck& one : failing) {
            const std::string& name = one.check->case_name;
            const RunOutcome& run = workshop.run_mistake(exercise, mistake.name, mistake.sources, name, cases.at(name).seed);
            const Tensor* tensor = tensor_of(run, one.check->value);
            if (tensor != nullptr && matches_mistake(one, *tensor)) ++matching;
        }
        if (matching == 0) continue;
        found.push_back({"mistake: " + mistake.name, mistake.hint, static_cast<double>(matching) / static_cast<double>(failing.size())});
    }
    return found;
}

}

std::vector<Explanation> explain_unit(Workshop& workshop, const Exercise& exercise, const UnitResult& result, const CaseResults& cases)
{
    const std::vector<FailingCheck> failing = failing_checks(workshop, exercise, result, cases);
    if (failing.empty()) return {};
    std::vector<Explanation> all = by_mistakes(workshop, exercise, failing, cases);
    for (Explanation& other : explain_by_transform(failing)) all.push_back(std::move(other));
    // Known mistakes come first among equals: their hints were written for this very unit.
    std::stable_sort(all.begin(), all.end(), [](const Explanation& a, const Explanation& b) { return a.confidence > b.confidence; });
    if (all.size() > most_explanations) all.resize(most_explanations);
    return all;
}

}
