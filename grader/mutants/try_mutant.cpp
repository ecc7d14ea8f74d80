#include "mutants/try_mutant.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "batch/case_results.hpp"
#include "batch/grade_unit.hpp"
#include "batch/seeds.hpp"

namespace umbral::grader {
namespace {

/// What a mutant may take: it hangs or it does not, and many of them are tried.
Exercise with_short_limits(Exercise exercise, double reference_seconds)
{
    exercise.limits = limits_for(exercise.limits, reference_seconds);
    return exercise;
}

Trial graded(Worker& worker, const Exercise& exercise, const Built& built, const SeedPlan& seeds)
{
    GradeOptions options;
    options.seeds = seeds;
    options.explain = false;
    options.questions = false;
    const UnitResult result = grade_built(worker, exercise, built, options);
    for (const CheckResult& check : result.checks)
        if (check.score < check.max_score) return {true, check.name};
    return {};
}

}

Trial try_mutant(Worker& worker, const Exercise& exercise, const std::filesystem::path& library, unsigned number,
                 const std::vector<std::string>& cases, unsigned seed)
{
    const SeedPlan seeds{"validate", "validate", "validate", seed, "validate"};
    Built built;
    built.verdict = Verdict::ok;
    built.library = library;
    built.mutant = number;
    bool borderline = false;
    for (const std::string& name : cases) {
        CaseResult one;
        one.seed = seeds.seed_of(exercise, name);
        one.hidden = is_hidden_case(exercise, name);
        const RunOutcome& reference = worker.trusted(exercise, Answers::reference, name, one.seed);
        // What the mutant is judged against has all the time it needs, and is remembered.
        for (const Check& check : exercise.checks)
            if (check.case_name == name) (void)worker.trusted(exercise, judged_against(check), name, one.seed);
        one.student = worker.run(with_short_limits(exercise, reference.wall_seconds), built, name, one.seed);
        if (one.student.verdict == Verdict::grader_fault) throw std::runtime_error(one.student.message);
        if (one.student.verdict != Verdict::ok)
            return {true, fmt::format("{} in {}", to_string(one.student.verdict), name)};
        for (const Check& check : exercise.checks) {
            if (check.case_name != name) continue;
            const RunOutcome& expected = worker.trusted(exercise, judged_against(check), name, one.seed);
            const CheckResult result = judge_check(check, one, expected, worker.basis(exercise, check, one.seed));
            if (result.score < result.max_score && !result.borderline) return {true, check.name};
            borderline = borderline || result.borderline;
        }
    }
    // What chance may have decided is graded as a submission is: with a second run.
    return borderline ? graded(worker, exercise, built, seeds) : Trial();
}

}
