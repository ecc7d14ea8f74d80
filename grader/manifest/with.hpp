#pragma once

#include "model/exercise.hpp"
#include "text/field.hpp"

namespace umbral::grader {

/// Refuses a check that hangs on another one (Check::with) which is not there, is hidden or hangs on one itself.
/// `checks` is the manifest's list, in the order of the exercise's.
void expect_known_with(const Field& checks, const Exercise& exercise);

}
