#include "mutants/try_mutant.hpp"

#include <fmt/format.h>

#include "mutants/try_case.hpp"
#include "unit/grade_unit.hpp"

namespace umbral::grader {
namespace {

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
    const SeedPlan seeds = validation_seeds(seed);
    const Built built = built_with(library, number);
    bool borderline = false;
    for (const std::string& name : cases) {
        const CaseTrial trial = try_case(worker, exercise, built, name, seeds);
        if (trial.run.verdict != Verdict::ok)
            return {true, fmt::format("{} in {}", to_string(trial.run.verdict), name)};
        for (const CheckResult& check : trial.checks) {
            if (!CaseTrial::is_right(check)) return {true, check.name};
            borderline = borderline || check.borderline;
        }
    }
    // What chance may have decided is graded as a submission is: with a second run.
    return borderline ? graded(worker, exercise, built, seeds) : Trial();
}

}
