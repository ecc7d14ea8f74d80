#pragma once

#include "report/html/evidence.hpp"
#include "unit/grade_unit.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {

/// What a page shows of a check, from the recordings of both sides. Nothing where there is nothing to show (another
/// shape, a kind that cannot be drawn). `right`: the check earned all its points; then only a picture is of interest.
/// Never throws for what a student recorded.
[[nodiscard]] Evidence evidence_of(const Check& check, const Observation& observation, bool right);

/// What the manifest says of a unit and its checks: bounds in words, and where they come from.
[[nodiscard]] html::UnitDetail describe(const Exercise& exercise);
[[nodiscard]] html::CheckDetail describe(const Check& check);

/// Adds evidence to a unit's details: for every check that fails, and for one picture of a unit that is right. Hidden
/// checks are left out unless the options ask for them; of their pictures students see `practice` instead.
void add_evidence(Worker& worker, const Exercise& exercise, const CaseResults& cases, const CaseResults& practice,
                  const GradeOptions& options, const UnitResult& result, html::UnitDetail& unit);

}
