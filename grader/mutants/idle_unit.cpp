#include "mutants/idle_unit.hpp"

#include <fmt/format.h>

#include "model/scratch.hpp"
#include "mutants/build_mutants.hpp"
#include "mutants/schemata.hpp"
#include "mutants/try_case.hpp"
#include "unit/grade_unit.hpp"

namespace umbral::grader {
namespace {

double points(Millipoints value) { return static_cast<double>(value) / 1000; }

}

IdleUnit try_idle(Worker& worker, const std::filesystem::path& finder, const Exercise& exercise, unsigned seed,
                  MutantFamily family)
{
    IdleUnit idle{exercise.id, family};
    try {
        const Toolchain& tools = worker.tools();
        const std::filesystem::path source = reference_files(tools.reference, exercise).begin()->second;
        const ScratchFolder work(tools.cache);
        const BuiltMutants built = build_mutants(tools, exercise, family, finder, read_text(source), work.path());
        GradeOptions options;
        options.seeds = validation_seeds(seed);
        options.explain = options.questions = false;
        const UnitResult result = grade_built(worker, exercise, built_with(built.library, all_mutants), options);
        idle.credit = 100 * points(result.score) / points(exercise.points);
        for (const CheckResult& check : result.checks)
            if (check.score > 0)
                idle.earning.push_back(
                    fmt::format("{} {:.2f} of {:.2f}", check.name, points(check.score), points(check.max_score)));
        if (result.verdict == Verdict::grader_fault) idle.trouble = result.message;
    } catch (const std::exception& error) {
        idle.trouble = error.what();
    }
    return idle;
}

}
