#pragma once

#include <span>
#include <string>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// "very likely", "probably"; "perhaps" for what no explanation should have. Never a number: what students read is no
/// measurement.
[[nodiscard]] const char* sure_words(double confidence);

/// Those that match equally well, of which one is the reason: one explanation, several if it is ambiguous, none if
/// there is none.
[[nodiscard]] std::span<const Explanation> main_reasons(const UnitResult& unit);
/// What else it may be, less likely.
[[nodiscard]] std::span<const Explanation> other_reasons(const UnitResult& unit);

/// "mistake: far_root" as people read it: "far root".
[[nodiscard]] std::string readable_reason(const Explanation& explanation);

}
