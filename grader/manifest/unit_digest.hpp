#pragma once

#include <string>

#include "model/exercise.hpp"

namespace umbral::grader {

/// SHA-256 over the names and bytes of all that decides a unit's score: manifest, stubs, driver, reference and oracle,
/// and every header of this project that these include, directly or not, wherever it lies (the unit's own, other
/// topics', interfaces). Names are relative to the project, so that it is the same on all machines. `exercise.folder`
/// must lie in `exercises/topic/unit`; `framework` and `reference` are looked for beside `exercises`. A unit of
/// students' packages has no sources: there `packaged_file` holds the digest. Throws std::runtime_error if manifest,
/// driver or a stub cannot be read.
[[nodiscard]] std::string unit_digest(const Exercise& exercise);

}
