#pragma once

#include <filesystem>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// Writes report.json for one submission: to_json's value, indented by two spaces, with a final line break.
///
/// Writes all that is known; give it without_hidden_values(…) for students. Invalid UTF-8 is replaced, numbers
/// that are not finite become null. Throws std::runtime_error with path and reason; never leaves a part of a file.
void write_report_json(const std::filesystem::path& path, const SubmissionResult& result, const Fingerprint& fingerprint);

/// The same for class.json.
void write_class_json(const std::filesystem::path& path, const ClassResult& result);

}
