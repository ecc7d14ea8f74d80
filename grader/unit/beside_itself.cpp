#include "unit/beside_itself.hpp"

#include <algorithm>

#include "explain/asked_alone.hpp"
#include "judge/judges.hpp"
#include "worker/seeds.hpp"

namespace umbral::grader {
namespace {

/// Longer ones make people wait, and what is kept shows in short ones as well.
constexpr double most_seconds = 1;
/// What is right when it is asked alone keeps so much of its points: the algorithm is right, and only where it keeps
/// its state is wrong.
constexpr Millipoints kept_of_ten = 8;

/// The places of a case's checks; none if it cannot be asked so, or if there is something wrong with it as it is.
std::vector<std::size_t> checks_of(const Exercise& exercise, const std::string& name, const UnitResult& result)
{
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        if (check.case_name != name) continue;
        if (judge_of(check).counts_work || judge_of(check).judge_both != nullptr) return {};
        if (result.checks[i].score < check.points) return {};
        places.push_back(i);
    }
    return places;
}

/// OpenGL is there once, for both: of a unit that draws, only cases that leave no picture.
bool may_draw(const Exercise& exercise, const RunOutcome& reference)
{
    return exercise.gl &&
           std::ranges::any_of(reference.recording.tensors, [](const auto& one) { return one.second.columns > 1; });
}

}

void expect_the_same_beside_others(Worker& worker, const Exercise& exercise, const Built& built, CaseResults& cases,
                                   const GradeOptions& options, UnitResult& result)
{
    if (!exercise.is_cpp() || exercise.gl_calls || exercise.glfw) return;
    for (auto& [name, one] : cases) {
        if (one.hidden || !one.reached || one.student.verdict != Verdict::ok || one.student.wall_seconds > most_seconds)
            continue;
        const std::vector<std::size_t> places = checks_of(exercise, name, result);
        if (places.empty() || !may_repeat(worker, exercise, one)) continue;
        if (may_draw(exercise, worker.trusted(exercise, Answers::reference, name, one.seed))) continue;
        const std::uint64_t other = options.seeds.two_seeds_of(exercise, name).second;
        CaseResult beside = one;
        beside.student = worker.run_beside(exercise, built, name, one.seed, other);
        if (beside.student.verdict != Verdict::ok) continue;
        std::vector<CheckResult> judged;
        bool worse = false;
        for (const std::size_t i : places) {
            const Check& check = exercise.checks[i];
            const RunOutcome& expected = worker.trusted(exercise, judged_against(check), name, one.seed);
            judged.push_back(judge_check(check, beside, expected, worker.basis(exercise, check, one.seed)));
            worse = worse || judged.back().score < result.checks[i].score;
        }
        if (!worse) continue;
        for (std::size_t i = 0; i < places.size(); ++i) {
            CheckResult& before = result.checks[places[i]];
            if (judged[i].score >= before.score) continue;
            const Millipoints kept = before.score * kept_of_ten / 10;
            before = std::move(judged[i]);
            before.score = std::max(before.score, kept);
            before.beside = true;
            before.common = right_without_others;
        }
        one.student = std::move(beside.student);
    }
}

}
