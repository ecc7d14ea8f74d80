#pragma once

#include <vector>

#include "model/curve.hpp"

namespace umbral::grader {

/// Where a point of a curve lies in a plot: both from 0 to 1, time to the right, error upwards.
struct CurvePlace {
    double x = 0;
    double y = 0;
};

/// The places of the others, in their order, and the student's last. Both axes are logarithms, at least a factor of two
/// of time and a decade of errors long; an error of 0 lies at the bottom, below a gap.
[[nodiscard]] std::vector<CurvePlace> curve_places(const UnitCurve& curve);

/// Those of the others that no other of them beats in both error and time, quickest first: indices.
[[nodiscard]] std::vector<std::size_t> curve_front(const UnitCurve& curve);

}
