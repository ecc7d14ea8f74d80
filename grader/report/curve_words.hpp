#pragma once

#include <string>

#include "model/curve.hpp"

namespace umbral::grader {

/// Times that differ by less than this factor, and errors that differ by less than that one, are told as equal: a run
/// made twice differs by as much.
inline constexpr double same_time = 1.25;
inline constexpr double same_error = 1.5;

/// Where the student's choice lies, in one plain sentence: "As accurate as “double precision”, in the time of “school
/// formula”." Names stand as they are; whoever shows them escapes them.
[[nodiscard]] std::string curve_sentence(const UnitCurve& curve);

/// "0.48 ulp", "1e-07 relative", "none".
[[nodiscard]] std::string curve_error_text(const UnitCurve& curve, double error);
/// "7.1 ms"
[[nodiscard]] std::string curve_time_text(double seconds);

}
