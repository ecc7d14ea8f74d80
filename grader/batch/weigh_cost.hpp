#pragma once

#include "batch/case_results.hpp"
#include "batch/worker.hpp"

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

}
