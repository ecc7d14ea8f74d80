#pragma once

#include "unit/grade_unit.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Asks visible cases that are all right once more, each beside itself with other inputs: three drivers take turns,
/// question by question (run/companion.hpp). Where an answer is wrong then, the code keeps something from one call to
/// the next that only answers right as long as nobody else asks: what the case earns is what that run earns, but no
/// less than eight tenths of its points, and it takes the place of the first one in `cases`.
///
/// Where it crashes then, twice, the case keeps those eight tenths; in `cases` its first run remains. A run that does
/// not end, or needs too much memory, proves nothing and changes nothing. Work that is counted or judged by chance is
/// left alone, and so are builds that have nowhere to keep anything, cases that draw, and units that call OpenGL or
/// answer events: a context and a window are there once. Takes spare time.
void expect_the_same_beside_others(Worker& worker, const Exercise& exercise, const Built& built, CaseResults& cases,
                                   const GradeOptions& options, UnitResult& result);

}
