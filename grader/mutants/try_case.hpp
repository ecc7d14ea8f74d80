#pragma once

#include <string>
#include <vector>

#include "model/exercise.hpp"
#include "model/scorecard.hpp"
#include "worker/seeds.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// One case of a library with mutants, run and judged.
struct CaseTrial {
    RunOutcome run;
    std::vector<CheckResult> checks;  ///< of the case, in the unit's order; none if the run did not end well

    /// Did this check earn all its points, or come so near that chance decides?
    [[nodiscard]] static bool is_right(const CheckResult& check)
    {
        return check.score >= check.max_score || check.borderline;
    }
};

/// Runs and judges a case as of a submission, within the time that it should take: a mutant hangs or it does not, and
/// many of them are tried. Throws std::runtime_error for a fault of the grader's.
[[nodiscard]] CaseTrial try_case(Worker& worker, const Exercise& exercise, const Built& built, const std::string& name,
                                 const SeedPlan& seeds);

/// A library with mutants, as what was handed in.
[[nodiscard]] Built built_with(const std::filesystem::path& library, unsigned mutant);

}
