#include "batch/explain_unit.hpp"

#include <algorithm>
#include <functional>
#include <list>
#include <map>

#include "batch/related.hpp"
#include "batch/specimens.hpp"
#include "judge/explain.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_explanations = 3;

/// The failing checks that could be judged at all: a crash needs no signature. Those with a relation are explained by what is wrong with
/// one of its values, as a check of its own that `plain` keeps.
std::vector<FailingCheck> failing_checks(Workshop& workshop, const Exercise& exercise, const UnitResult& result, const CaseResults& cases,
                                         std::list<Check>& plain)
{
    std::vector<FailingCheck> failing;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& declared = exercise.checks[i];
        const CaseResult& one = cases.at(declared.case_name);
        if (result.checks[i].score == declared.points || !one.trouble().empty()) continue;
        const RunOutcome& expected = workshop.trusted(exercise, judged_against(declared), declared.case_name, one.seed);
        const Check& check = declared.relation ? plain.emplace_back(against_reference(declared, one.student, expected)) : declared;
        const Tensor* student = observed(check, one.student);
        if (student == nullptr) continue;
        failing.push_back({&check, student, tensor_of(expected, check.value), tensor_of(expected, check.value + ".margin"), nullptr});
    }
    return failing;
}

struct Candidate {
    Specimen mistake;
    std::size_t matching = 0;  ///< failing checks with the same wrong result
    bool fits_here = false;    ///< one of them belongs to the case looked at
};

/// The failing checks by case, the quickest case first: most mistakes are told apart by one case.
std::vector<std::vector<FailingCheck>> by_case(const std::vector<FailingCheck>& failing, const CaseResults& cases)
{
    std::map<std::pair<double, std::string>, std::vector<FailingCheck>> sorted;
    for (const FailingCheck& one : failing) sorted[{cases.at(one.check->case_name).student.wall_seconds, one.check->case_name}].push_back(one);
    std::vector<std::vector<FailingCheck>> groups;
    for (auto& [key, group] : sorted) groups.push_back(std::move(group));
    return groups;
}

std::vector<Explanation> by_mistakes(Workshop& workshop, const Exercise& exercise, const std::vector<FailingCheck>& failing, const CaseResults& cases)
{
    std::vector<Candidate> candidates;
    for (Specimen& mistake : mistakes_of(workshop.tools().reference, exercise))
        if (!mistake.verdict || *mistake.verdict == Verdict::wrong || *mistake.verdict == Verdict::partial) candidates.push_back({std::move(mistake)});

    // A mistake that fits no check of a failing case is out, as long as another fits there: a unit's mistakes may be many and slow.
    for (const std::vector<FailingCheck>& group : by_case(failing, cases)) {
        for (Candidate& candidate : candidates) {
            candidate.fits_here = false;
            const std::string& name = group.front().check->case_name;
            const RunOutcome& run = workshop.run_mistake(exercise, candidate.mistake.name, candidate.mistake.sources, name, cases.at(name).seed);
            for (const FailingCheck& one : group) {
                const Tensor* tensor = observed(*one.check, run);
                if (tensor == nullptr || !matches_mistake(one, *tensor)) continue;
                ++candidate.matching;
                candidate.fits_here = true;
            }
        }
        const auto fits = [](const Candidate& candidate) { return candidate.fits_here; };
        if (std::any_of(candidates.begin(), candidates.end(), fits)) std::erase_if(candidates, std::not_fn(fits));
    }
    std::vector<Explanation> found;
    for (const Candidate& candidate : candidates)
        if (candidate.matching > 0)
            found.push_back(
                {"mistake: " + candidate.mistake.name, candidate.mistake.hint, static_cast<double>(candidate.matching) / static_cast<double>(failing.size())});
    return found;
}

}

std::vector<Explanation> explain_unit(Workshop& workshop, const Exercise& exercise, const UnitResult& result, const CaseResults& cases)
{
    std::list<Check> plain;
    const std::vector<FailingCheck> failing = failing_checks(workshop, exercise, result, cases, plain);
    if (failing.empty()) return {};
    std::vector<Explanation> all = by_mistakes(workshop, exercise, failing, cases);
    for (Explanation& other : explain_by_transform(failing)) all.push_back(std::move(other));
    // Known mistakes come first among equals: their hints were written for this very unit.
    std::stable_sort(all.begin(), all.end(), [](const Explanation& a, const Explanation& b) { return a.confidence > b.confidence; });
    if (all.size() > most_explanations) all.resize(most_explanations);
    return all;
}

}
