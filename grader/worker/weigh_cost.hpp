#pragma once

#include <optional>

#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Holds counted work that earned points against what the runs took as seen from outside their process, which the
/// student's code cannot change as it can the count. A count that is contradicted loses its points, with a sentence
/// that says by what.
///
/// Nothing is measured while the run of the case took about as long as the reference's. Else student's and reference's
/// runs alternate, with all sizes, some, and none, and the least time of each is compared, since anything may run
/// beside. Throws std::runtime_error for a fault of ours.
void weigh_costs(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                 UnitResult& result);

/// Of a cost that earns nothing because the answers to the counted work are wrong: a check of what these amount to, for
/// explanations, since the work itself may be as it should. Nothing for other checks, or if the answers are right.
[[nodiscard]] std::optional<Check> check_of_answers(const Check& check, const RunOutcome& student,
                                                    const RunOutcome& expected);

}
