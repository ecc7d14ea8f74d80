#pragma once

#include <string>

#include "model/exercise.hpp"

namespace umbral::grader {

/// The unit in which errors are counted: the first of these that the tolerance gives.
enum class Unit { ulps, relative, absolute };

/// What an expected component is measured against.
struct Scale {
    double ulp = 0;   ///< one unit in the last place
    double size = 0;  ///< what relative errors are relative to
};

/// How far one component lies from the expected one.
struct Deviation {
    bool right = false;   ///< at least one of the given bounds holds; never for a non-finite value
    bool within = false;  ///< the bound of the unit itself holds
    double error = 0;     ///< in the unit of the tolerance; infinite for a non-finite value, or relative to nothing
};

[[nodiscard]] bool has_bound(const Tolerance& tolerance);
[[nodiscard]] Unit unit_of(const Tolerance& tolerance);

/// The check with each bound thresholds::clear_ratio times as wide: what is wrong by this, too, no rounding explains.
[[nodiscard]] Check with_wide_bounds(Check check);

/// Spacing of the floats just above |value|; for values beyond float's range, of the largest floats.
[[nodiscard]] double float_ulp(double value);

[[nodiscard]] Deviation deviation(const Tolerance& tolerance, double student, double expected, const Scale& scale);

/// So many units in the last place are a sixteenth of a number: nothing that is counted in these any more.
inline constexpr double no_rounding = 1 << 20;

/// "160 ulp", "far more than rounding" from no_rounding on, "0.5 %"-like relative error as "relative error 0.005",
/// "error 0.25".
[[nodiscard]] std::string error_text(Unit unit, double error);

}
