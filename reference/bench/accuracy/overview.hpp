#pragma once

#include <string>

#include "measurement.hpp"

namespace umbral::bench {

/// All knobs at one glance, as HTML: a card each with its curve, knee and slopes, that leads to the knob's section.
[[nodiscard]] std::string overview_of(const Accuracy& accuracy);

/// The curve of a knob that a card and a table show: its first measure, in the situation in the middle.
[[nodiscard]] const Curve& main_curve_of(const Knob& knob);

/// A slope for a narrow place: "-0.51 ± 0.03 (−½ ✓)".
[[nodiscard]] std::string slope_text(const Law& law);

}
