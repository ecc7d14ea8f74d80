#pragma once

#include <span>
#include <vector>

#include "worker/case_results.hpp"
#include "worker/known_solutions.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Why a unit's checks fail: known mistakes that give the same results, and named transforms that undo the difference;
/// best first, with how sure that is (judge/confidence.hpp). Runs the unit's mistakes, which were compiled when the
/// project was built, in the sandbox like everything else: on the failing cases, and those that still fit on the others
/// too, for what a mistake breaks must be broken. First come those that visible cases alone lead to. Those that only
/// hidden ones lead to are marked `hidden`: which explanation a student reads must tell nothing about hidden inputs.
[[nodiscard]] std::vector<Explanation> explain_unit(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                                    const CaseResults& cases);

/// The same with other candidates than the unit's own mistakes.
[[nodiscard]] std::vector<Explanation> explain_unit(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                                    const CaseResults& cases, std::span<const KnownSolution> mistakes);

/// The mistakes that can explain a result: those that build, run, and answer wrongly.
[[nodiscard]] std::vector<KnownSolution> explaining_mistakes(const Worker& worker, const Exercise& exercise);

}
