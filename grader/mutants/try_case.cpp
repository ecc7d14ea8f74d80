#include "mutants/try_case.hpp"

#include <stdexcept>

#include "unit/grade_unit.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {
namespace {

Exercise with_short_limits(Exercise exercise, double reference_seconds)
{
    exercise.limits = limits_for(exercise.limits, reference_seconds);
    return exercise;
}

}

CaseTrial try_case(Worker& worker, const Exercise& exercise, const Built& built, const std::string& name,
                   const SeedPlan& seeds)
{
    CaseResult one;
    one.seed = seeds.seed_of(exercise, name);
    one.hidden = is_hidden_case(exercise, name);
    const RunOutcome& reference = worker.trusted(exercise, Answers::reference, name, one.seed);
    // What the mutant is judged against has all the time it needs, and is remembered.
    for (const Check& check : exercise.checks)
        if (check.case_name == name) (void)worker.trusted(exercise, judged_against(check), name, one.seed);
    one.student = worker.run(with_short_limits(exercise, reference.wall_seconds), built, name, one.seed);
    if (one.student.verdict == Verdict::grader_fault) throw std::runtime_error(one.student.message);
    CaseTrial trial;
    for (const Check& check : exercise.checks) {
        if (check.case_name != name || one.student.verdict != Verdict::ok) continue;
        const RunOutcome& expected = worker.trusted(exercise, judged_against(check), name, one.seed);
        trial.checks.push_back(judge_check(check, one, expected, worker.basis(exercise, check, one.seed)));
    }
    trial.run = std::move(one.student);
    return trial;
}

Built built_with(const std::filesystem::path& library, unsigned mutant)
{
    Built built;
    built.verdict = Verdict::ok;
    built.library = library;
    built.mutant = mutant;
    return built;
}

}
