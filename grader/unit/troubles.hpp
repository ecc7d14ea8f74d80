#pragma once

#include <string>

#include "worker/case_results.hpp"

namespace umbral::grader {

/// What kept cases from being judged, or was refused on the way, as the student may read it: a line for each cause,
/// with all cases that it stopped. Of hidden cases, only the kind of trouble
/// is told: whatever their runs said or chose may hold their inputs.
[[nodiscard]] std::string troubles(const CaseResults& cases);

}
