#pragma once

#include <cmath>

namespace umbral::grader {

/// Finite, and without a fraction.
[[nodiscard]] inline bool is_whole_number(double x) { return std::isfinite(x) && x == std::round(x); }

}
