#include "unit/beside_itself.hpp"

#include <algorithm>
#include <utility>

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
        if (judge_of(check).counts_work || is_by_chance(check)) return {};
        if (result.checks[i].score < check.points) return {};
        places.push_back(i);
    }
    return places;
}

/// A check that was all right has earned so much beside others, for the reason that is told.
void mark_beside(CheckResult& check, Millipoints earned, const char* why)
{
    check.score = std::max(earned, check.max_score * kept_of_ten / 10);
    check.beside = true;
    check.common = why;
}

}

void expect_the_same_beside_others(Worker& worker, const Exercise& exercise, const Built& built, CaseResults& cases,
                                   const GradeOptions& options, UnitResult& result)
{
    if (!exercise.is_cpp() || exercise.gl_calls || exercise.glfw || built.keeps_nothing) return;
    for (auto& [name, one] : cases) {
        if (one.hidden || !one.reached || one.student.verdict != Verdict::ok || one.student.wall_seconds > most_seconds)
            continue;
        const std::vector<std::size_t> places = checks_of(exercise, name, result);
        if (places.empty() || !may_repeat(worker, exercise, one)) continue;
        // OpenGL is there once, for both.
        if (exercise.gl && leaves_picture(worker.trusted(exercise, Answers::reference, name, one.seed))) continue;
        const std::uint64_t other = options.seeds.two_seeds_of(exercise, name).second;
        const auto ask = [&] { return worker.run_beside(exercise, built, name, one.seed, other); };
        RunOutcome run = ask();
        // It has as much stack and memory as before: what crashes then, and twice, does so for what it kept.
        if (run.verdict == Verdict::crashed && ask().verdict == Verdict::crashed)
            for (const std::size_t i : places) mark_beside(result.checks[i], 0, crashes_beside_others);
        if (run.verdict != Verdict::ok) continue;
        std::swap(one.student, run);  // judged in its place, and put back if all is right
        for (const std::size_t i : places) {
            const Check& check = exercise.checks[i];
            CheckResult& before = result.checks[i];
            const RunOutcome& expected = worker.trusted(exercise, judged_against(check), name, one.seed);
            CheckResult found = judge_check(check, one, expected, worker.basis(exercise, check, one.seed));
            if (found.score >= before.score) continue;
            before = std::move(found);
            mark_beside(before, before.score, right_without_others);
            one.beside = true;
        }
        if (!one.beside) one.student = std::move(run);
    }
}

}
