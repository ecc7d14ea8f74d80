#pragma once

#include <cstddef>
#include <vector>

#include "model/exercise.hpp"
#include "text/field.hpp"

namespace umbral::grader {

// How exercise.json says what a unit and its parts are worth.

/// Points above 0, with at most three decimal places.
[[nodiscard]] Millipoints read_points(const Field& field);

/// The lines of the rubric by which a course marks a unit; none if the field is not given.
[[nodiscard]] std::vector<RubricLine> read_rubric(const Field& field);

/// The line that a check says it belongs to, from 0 on; manifests count them from 1. In a unit with `lines` lines each
/// check belongs to one, in one without them none does.
[[nodiscard]] std::size_t read_rubric_line(const Field& field, std::size_t lines);

/// Refuses a rubric of which a line has other points than its checks together.
void expect_rubric_of_checks(const Field& field, const Exercise& exercise);

}
