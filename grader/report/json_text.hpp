#pragma once

#include <string>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// report.json of one submission: to_json's value, indented by two spaces, with a final line break.
///
/// Says all that is known; give it without_hidden_values(…) for students. Invalid UTF-8 is replaced, numbers that are
/// not finite become null.
[[nodiscard]] std::string report_json(const SubmissionResult& result, const Fingerprint& fingerprint);

/// The same for class.json.
[[nodiscard]] std::string class_json(const ClassResult& result);

}
