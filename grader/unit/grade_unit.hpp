#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "build/submission.hpp"
#include "model/exercise.hpp"
#include "model/scorecard.hpp"
#include "model/time_budget.hpp"
#include "report/html/evidence.hpp"
#include "worker/known_solutions.hpp"
#include "worker/seeds.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// How much to do beside the points.
struct GradeOptions {
    SeedPlan seeds;
    bool explain = true;
    bool questions = true;              ///< what was asked behind wrong values, and what those have in common
    std::filesystem::path artefacts;    ///< where pictures go; empty for none
    std::filesystem::path relative_to;  ///< pictures are named relative to this in the report
    SubmissionBudgets budgets{};
    bool other_inputs = false;  ///< visible cases must earn their points with secret inputs too
    bool show_hidden = false;   ///< evidence of hidden checks too: for instructors only
};

/// Grades what was handed in for one unit. Never throws for what a student did; what goes wrong on our side becomes the
/// verdict grader_fault, which takes the unit out of the sum.
[[nodiscard]] UnitResult grade_unit(Worker& worker, const Exercise& exercise, const Handed& handed,
                                    const GradeOptions& options);

/// A graded unit, and what pages show of it beside its result.
struct GradedUnit {
    UnitResult result;
    html::UnitDetail detail;
};

/// The same with evidence.
[[nodiscard]] GradedUnit grade_with_evidence(Worker& worker, const Exercise& exercise, const Handed& handed,
                                             const GradeOptions& options);

/// The same of what has been built.
[[nodiscard]] UnitResult grade_built(Worker& worker, const Exercise& exercise, const Built& built,
                                     const GradeOptions& options);

/// grade_unit for one of the unit's mistakes, which was compiled with the project: what explains students' results is
/// itself graded.
[[nodiscard]] UnitResult grade_mistake(Worker& worker, const Exercise& exercise, const KnownSolution& mistake,
                                       const GradeOptions& options);

}
