#pragma once

#include <span>
#include <string>

#include "report/html/pages.hpp"

namespace umbral::grader::html {

/// Stands in a unit's section where its number within the report belongs. No text from outside holds it: escaping shows
/// control characters.
inline constexpr char number_slot = '\x01';

/// One unit of a report: verdict, why, what was printed, time, and its checks; with number_slot in its anchors ("u1",
/// "u1-c1").
[[nodiscard]] Markup unit_section(const UnitResult& unit, const UnitDetail& detail, Edition edition);

/// What the reason probably is, of explanations that are listed best first, and what else it may be.
[[nodiscard]] Markup why_section(std::span<const Explanation> explanations);

/// One check that is not right, or is worth a look: its words, its error and its evidence.
[[nodiscard]] Markup check_article(const CheckResult& check, const CheckDetail& detail, const Markup& anchor,
                                   bool with_points = true);

/// Where the student's choice lies on the curve of the unit's knob: its sentence, a plot, and the figures.
[[nodiscard]] Markup curve_section(const UnitCurve& curve);

/// Evidence of each kind.
[[nodiscard]] Markup picture_evidence(const PictureEvidence& evidence, const Markup& anchor);
[[nodiscard]] Markup rows_evidence(const RowsEvidence& evidence);
[[nodiscard]] Markup lines_evidence(const LinesEvidence& evidence);
[[nodiscard]] Markup fragments_evidence(const FragmentsEvidence& evidence);
[[nodiscard]] Markup cost_evidence(const CostEvidence& evidence);

/// A table that may be wider than the window: it scrolls by itself, by keyboard too.
[[nodiscard]] Markup scrolling(std::string_view label, const Markup& table);

/// "ok", "partial", "bad", "none" or "fault": the class that colours a verdict; its words are always there too.
[[nodiscard]] const char* kind_of(Verdict verdict);
/// The verdict's sign in front of its words.
[[nodiscard]] Markup verdict_chip(Verdict verdict);

/// What stands above a class's table: whose points are in no sum and why, what is unfinished. Empty if there is
/// nothing.
[[nodiscard]] Markup class_notices(const ClassResult& result);

/// What the result depends on, for the foot of a page.
[[nodiscard]] Markup fingerprint_footer(const Fingerprint& fingerprint);

}
