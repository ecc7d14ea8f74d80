#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "batch/workshop.hpp"
#include "build/submission.hpp"
#include "model/exercise.hpp"
#include "model/scorecard.hpp"
#include "report/html/evidence.hpp"

namespace umbral::grader {

/// Which random inputs a submission meets. Visible cases have the same for all; hidden ones follow from a secret and the student.
struct SeedPlan {
    std::string secret = "practice";
    std::string course = "course";
    std::string student = "student";
    unsigned attempt = 0;

    /// The seed of a unit's case.
    [[nodiscard]] std::uint64_t seed_of(const Exercise& exercise, const std::string& case_name) const;
    /// The seed with which a borderline case is run again: as secret, and unrelated to it.
    [[nodiscard]] std::uint64_t fresh_seed_of(const Exercise& exercise, const std::string& case_name) const;
};

/// How much to do beside the points.
struct GradeOptions {
    SeedPlan seeds;
    bool explain = true;
    std::filesystem::path artefacts;    ///< where pictures go; empty for none
    std::filesystem::path relative_to;  ///< pictures are named relative to this in the report
    html::Gallery* gallery = nullptr;   ///< receives what pages show of the unit beside its result; null for nothing
    bool show_hidden = false;           ///< of hidden checks too: for instructors only
};

/// Grades what was handed in for one unit. Never throws for what a student did; what goes wrong on our side becomes the verdict
/// grader_fault, which takes the unit out of the sum.
[[nodiscard]] UnitResult grade_unit(Workshop& workshop, const Exercise& exercise, const Handed& handed, const GradeOptions& options);

/// Is any check of this case hidden?
[[nodiscard]] bool is_hidden_case(const Exercise& exercise, const std::string& case_name);

}
