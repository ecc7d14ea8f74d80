#pragma once

#include <optional>
#include <umbral/core/grid.hpp>

#include "unit/grade_unit.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {

/// Writes a triptych (yours, reference, difference) for every failing picture, of hidden ones as the work draws them
/// with practice inputs (explain/practice_example.hpp), and one for a unit that passes; notes their paths in the
/// result. A picture that cannot be written is left out: points do not depend on it.
void save_pictures(Worker& worker, const Exercise& exercise, const CaseResults& cases, const CaseResults& practice,
                   const GradeOptions& options, UnitResult& result);

/// The goal picture of a unit: its first picture or buffer, as the reference draws it. None if it has no such check.
[[nodiscard]] std::optional<Image> goal_picture(Worker& worker, const Exercise& exercise);
/// Writes it as a PNG; false if there is none.
bool save_goal(Worker& worker, const Exercise& exercise, const std::filesystem::path& file);

}
