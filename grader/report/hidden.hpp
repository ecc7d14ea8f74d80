#pragma once

#include "model/scorecard.hpp"

namespace umbral::grader {

/// The result without anything from which a hidden case's inputs or values could be read: of hidden checks there remain
/// name, kind, points and verdict; explanations stay if visible cases alone lead to them. What students may see is made
/// from this, so that no report can show more. `message`, `output`, `seconds` and the unit's verdict are shown: whoever
/// fills them (unit/grade_unit.cpp) puts in nothing that a hidden case's run chose but the kind of its end.
[[nodiscard]] SubmissionResult without_hidden_values(SubmissionResult submission);

/// Did the unit earn everything: verdict ok, at least one check, and no check, seen or hidden, below its points?
[[nodiscard]] bool all_right(const UnitResult& unit);

/// The verdict that a report may show: ok only if all_right, otherwise partial (a fault of the grader's books is no
/// praise).
[[nodiscard]] Verdict shown_verdict(const UnitResult& unit);

}
