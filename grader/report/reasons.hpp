#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// "very likely", "probably"; "perhaps" for what no explanation should have. Never a number: what students read is no
/// measurement.
[[nodiscard]] const char* sure_words(double confidence);

/// Of explanations, best first, those that match equally well, of which one is the reason: one explanation, several if
/// it is ambiguous, none if there is none.
[[nodiscard]] std::span<const Explanation> main_reasons(std::span<const Explanation> all);
[[nodiscard]] inline auto main_reasons(const UnitResult& unit) { return main_reasons(unit.explanations); }
/// What else it may be, less likely.
[[nodiscard]] std::span<const Explanation> other_reasons(std::span<const Explanation> all);
[[nodiscard]] inline auto other_reasons(const UnitResult& unit) { return other_reasons(unit.explanations); }

/// The main reasons as sentences, with "Either: " and "or: " before several, and how sure it is after the last.
[[nodiscard]] std::vector<std::string> reason_sentences(std::span<const Explanation> all);

/// "mistake: far_root" as people read it: "far root".
[[nodiscard]] std::string readable_reason(const Explanation& explanation);

}
