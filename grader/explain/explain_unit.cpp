#include "explain/explain_unit.hpp"

#include <algorithm>
#include <functional>
#include <list>
#include <optional>
#include <span>
#include <tuple>

#include "explain/by_function.hpp"
#include "explain/explained_checks.hpp"
#include "explain/mistakes_ahead.hpp"
#include "explain/other_questions.hpp"
#include "explain/two_mistakes.hpp"
#include "judge/explain/explain.hpp"
#include "judge/explain/thresholds.hpp"
#include "judge/judges.hpp"
#include "worker/packaged_unit.hpp"

namespace umbral::grader {
namespace {

struct LikelyMistake {
    const KnownSolution* mistake = nullptr;
    Tally tally{};
    bool fits_here = false;  ///< a failing check of the case looked at speaks for it
};

/// Drawing costs a hundred times what numbers do, and a unit's mistakes may be thirty: one that so many checks speak
/// against, and none for, is not tried on the other cases.
constexpr std::size_t enough_against = 1;

std::vector<Explanation> by_mistakes(Worker& worker, const Exercise& exercise, const std::vector<CaseChecks>& groups,
                                     std::span<const KnownSolution> mistakes)
{
    std::vector<LikelyMistake> candidates;
    for (const KnownSolution& mistake : mistakes) candidates.push_back({&mistake});
    std::size_t undecided = 0;
    for (const CaseChecks& group : groups) undecided += group.failing;

    for (const CaseChecks& group : groups) {
        undecided -= group.failing;
        // A mistake that explains runs to its end: none is like a run that the clock stopped.
        const bool stopped = group.result->student.verdict == Verdict::timeout;
        std::vector<const KnownSolution*> to_run;
        if (!stopped)
            for (const LikelyMistake& candidate : candidates) to_run.push_back(candidate.mistake);
        const MistakesAhead ahead(worker, exercise, group.name, group.result->seed, std::move(to_run));
        for (LikelyMistake& candidate : candidates) {
            candidate.fits_here = false;
            if (stopped) {
                for (std::size_t i = 0; i < group.checks.size(); ++i) candidate.tally += not_alike;
                continue;
            }
            const RunOutcome& run = worker.run_known(exercise, *candidate.mistake, group.name, group.result->seed);
            for (const FailingCheck& one : group.checks) {
                const Resemblance said = says_of(one, *group.result, run);
                candidate.tally += said;
                candidate.fits_here = candidate.fits_here || said.says == Says::for_it;
            }
        }
        std::erase_if(candidates, [&](const LikelyMistake& one) {
            const bool unlike = exercise.gl && one.tally.for_it == 0 && one.tally.against_it >= enough_against;
            return unlike || most_confidence(one.tally, undecided) < thresholds::least_sure;
        });
        // A unit's mistakes may be many and slow: one that fits no failing check of a case is out, as long as another
        // fits there.
        if (group.failing > 0 && std::ranges::any_of(candidates, &LikelyMistake::fits_here))
            std::erase_if(candidates, std::not_fn(&LikelyMistake::fits_here));
    }
    std::vector<Explanation> found;
    for (const LikelyMistake& candidate : candidates)
        found.push_back({mistake_title(candidate.mistake->name), candidate.mistake->hint, confidence(candidate.tally),
                         fit(candidate.tally)});
    return found;
}

/// What is wrong with what was recorded by itself.
std::optional<Explanation> first_fault(const std::vector<CaseChecks>& groups)
{
    for (const CaseChecks& group : groups) {
        if (!group.result->cause().empty()) continue;
        for (const FailingCheck& one : group.checks) {
            const auto fault_of = judge_of(*one.check).fault;
            if (fault_of == nullptr || one.student == nullptr) continue;
            if (auto fault = fault_of(one)) return fault;
        }
    }
    return std::nullopt;
}

/// A reason that visible checks speak for, and that is none where hidden ones which fail are looked at too, fits by
/// chance, or is not the only one: it is not very likely. Other questions are asked of visible checks only.
void doubt_what_hidden_checks_deny(const std::vector<Explanation>& all, std::vector<Explanation>& found)
{
    constexpr double doubted = (thresholds::least_sure + thresholds::very_sure) / 2;
    for (Explanation& one : found)
        if (!one.name.starts_with(question_reason) &&
            std::ranges::none_of(all, [&](const Explanation& other) { return other.name == one.name; }))
            one.confidence = std::min(one.confidence, doubted);
}

/// Are mistakes tried two at a time where no single one is the reason?
enum class Pairs { none, tried };

/// Why these checks fail, of one kind or of both.
std::vector<Explanation> reasons(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                 const CaseResults& cases, std::span<const KnownSolution> mistakes, Pairs pairs);

/// Why checks fail, hidden ones among them. Hidden cases ask each work its own questions, so that every mistake must
/// run for each: where visible checks name a mistake that explains all, and hidden ones agree, no other is tried; and
/// where visible ones fail as no two mistakes do, all do not fail as two do.
std::vector<Explanation> explained_by(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                      const CaseResults& cases, const std::vector<Explanation>& from_seen,
                                      bool fails_seen, const std::vector<KnownSolution>& mistakes)
{
    std::vector<KnownSolution> named;
    for (const KnownSolution& mistake : mistakes)
        if (std::ranges::any_of(from_seen, [&](const Explanation& one) {
                return one.name == mistake_title(mistake.name) && explains_all(one);
            }))
            named.push_back(mistake);
    if (!named.empty()) {
        std::vector<Explanation> all = explain_unit(worker, exercise, result, cases, named);
        if (std::ranges::any_of(all, explains_all)) return all;
    }
    const bool has_pair =
        std::ranges::any_of(from_seen, [](const Explanation& one) { return one.name.starts_with(two_mistakes_begin); });
    return reasons(worker, exercise, result, cases, mistakes, !fails_seen || has_pair ? Pairs::tried : Pairs::none);
}

std::vector<Explanation> reasons(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                 const CaseResults& cases, std::span<const KnownSolution> mistakes, Pairs pairs)
{
    std::list<Check> plain;
    const std::vector<CaseChecks> groups = checks_by_case(worker, exercise, result, cases, plain);
    // What crashed or was stopped has no result to explain.
    std::vector<FailingCheck> ran;
    for (const CaseChecks& group : groups)
        if (group.result->cause().empty())
            std::ranges::copy_if(group.checks, std::back_inserter(ran),
                                 [](const FailingCheck& one) { return one.student != nullptr; });
    if (std::ranges::none_of(ran, &FailingCheck::fails)) return {};
    std::vector<Explanation> all = by_mistakes(worker, exercise, groups, mistakes);
    const auto explained = [&] {
        return std::ranges::any_of(
            all, [](const Explanation& one) { return one.fit == 1 && one.confidence >= thresholds::very_sure; });
    };
    // A known mistake that explains all has a hint written for the unit: what is tried for all units can say no more.
    if (!explained())
        for (Explanation& other : explain_by_transform(ran)) all.push_back(std::move(other));
    if (!explained()) {
        if (auto fault = first_fault(groups)) all.push_back(*std::move(fault));
        const FunctionParts parts = parts_by_function(worker, exercise, groups);
        for (Explanation& other : transforms_by_function(parts)) all.push_back(std::move(other));
        for (Explanation& other : mistakes_by_function(worker, exercise, parts, mistakes)) {
            // Weighed over all answers the same mistake is less sure, if it is anything.
            std::erase_if(all, [&](const Explanation& one) { return one.name == other.name; });
            all.push_back(std::move(other));
        }
    }
    // Where nothing else explains all, and once, of what students may know.
    if (!explained() && std::ranges::none_of(groups, [](const CaseChecks& group) { return group.result->hidden; }))
        for (Explanation& other : by_other_questions(worker, exercise, groups)) all.push_back(std::move(other));
    std::vector<Explanation> best = ranked(std::move(all));
    if (pairs == Pairs::none || (!best.empty() && best.front().confidence >= thresholds::very_sure)) return best;
    std::vector<Explanation> two = by_two_mistakes(worker, exercise, groups, mistakes);
    return two.empty() ? best : two;
}

}

std::vector<KnownSolution> explaining_mistakes(const Worker& worker, const Exercise& exercise)
{
    std::vector<KnownSolution> mistakes = known_mistakes(worker.tools(), exercise);
    std::erase_if(mistakes, [](const KnownSolution& one) {
        return one.verdict && *one.verdict != Verdict::wrong && *one.verdict != Verdict::partial;
    });
    return mistakes;
}

std::vector<Explanation> explain_unit(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                      const CaseResults& cases, std::span<const KnownSolution> mistakes)
{
    return reasons(worker, exercise, result, cases, mistakes, Pairs::tried);
}

std::vector<Explanation> explain_unit(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                      const CaseResults& cases)
{
    if (result.score == result.max_score) return {};
    const std::vector<KnownSolution> mistakes = explaining_mistakes(worker, exercise);
    Exercise seen = exercise;
    UnitResult seen_result;
    seen.checks.clear();
    bool fails_hidden = false;
    bool fails_seen = false;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        if (cases.at(exercise.checks[i].case_name).hidden) {
            fails_hidden = fails_hidden || result.checks[i].score < exercise.checks[i].points;
            continue;
        }
        fails_seen = fails_seen || result.checks[i].score < exercise.checks[i].points;
        seen.checks.push_back(exercise.checks[i]);
        seen_result.checks.push_back(result.checks[i]);
    }
    std::vector<Explanation> found = explain_unit(worker, seen, seen_result, cases, mistakes);
    if (seen.checks.size() == exercise.checks.size()) return found;
    std::vector<Explanation> all = explained_by(worker, exercise, result, cases, found, fails_seen, mistakes);
    const std::size_t from_seen = found.size();
    if (fails_hidden) doubt_what_hidden_checks_deny(all, found);
    for (Explanation& one : all) {
        if (std::ranges::any_of(found, [&](const Explanation& other) { return other.name == one.name; })) continue;
        one.hidden = true;
        one.ambiguous = one.ambiguous && from_seen == 0;
        found.push_back(std::move(one));
    }
    return found;
}

}
