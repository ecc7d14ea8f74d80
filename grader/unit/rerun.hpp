#pragma once

#include "unit/grade_unit.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {

/// Judges the borderline noise checks of a result again: their cases run once more, student's and expected, with a
/// fresh seed that follows from the same secret, and both runs are judged together. Seeds of both go into the check's
/// result, and a line into its message. A second run that fails makes the check wrong. Of correct work, one noise check
/// in a hundred is run again.
void rerun_borderline(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                      const GradeOptions& options, UnitResult& result);

}
