#pragma once

#include <optional>

#include "model/exercise.hpp"
#include "text/field.hpp"

namespace umbral::grader {

/// The knob that the unit turns; none if the field is not given. `exercise` has its checks already: the one that is
/// named must be there, visible, and give an error; the case that is timed must be one of theirs, and visible.
[[nodiscard]] std::optional<UnitKnob> read_unit_knob(const Field& field, const Exercise& exercise);

}
