#pragma once

#include <string>
#include <vector>

#include "model/curve.hpp"
#include "report/paint.hpp"

namespace umbral::grader {

/// The curve for a terminal: a plot of error over time with the student's own point, what its letters mean, and the
/// sentence. At most `width` cells.
[[nodiscard]] std::vector<std::string> curve_plot(const UnitCurve& curve, int width, const Paint& paint);

/// The sentence alone, as people may read it.
[[nodiscard]] std::string shown_sentence(const UnitCurve& curve, const Paint& paint);

}
