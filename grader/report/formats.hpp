#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// What the reports of one submission are made from.
struct SubmissionReport {
    const SubmissionResult& result;  ///< all that is known, of hidden checks too
    const Fingerprint& fingerprint;
    const std::map<std::string, std::string>& titles;  ///< of units, by id
    bool with_hidden = false;                          ///< write the files with hidden values too
    std::vector<std::string> student_sections{};       ///< html::section_html's texts for students, one a unit
    std::vector<std::string> instructor_sections{};    ///< … and for instructors, with hidden values
};

/// What a class's reports are made from.
struct ClassReport {
    const ClassResult& result;
    std::map<std::string, std::string> titles;  ///< of units, by id
    bool with_hidden = false;                   ///< submissions have the files that show hidden values
};

/// One file that grading writes, and how its text is made.
template <class Report>
struct ReportFile {
    std::string_view name;
    std::string (*text)(const Report& report);
    bool hidden_values = false;  ///< shows values of hidden checks on a page: written only where they were asked for
};

/// All files that grading writes of each submission, into its folder, and of a class. A new format is a file that makes
/// its text, and a line in formats.cpp.
[[nodiscard]] std::span<const ReportFile<SubmissionReport>> submission_files();
[[nodiscard]] std::span<const ReportFile<ClassReport>> class_files();

/// Writes the files into `folder`, each whole or not at all, and removes those with hidden values that were not asked
/// for. Throws std::runtime_error with path and reason.
void write_reports(const std::filesystem::path& folder, const SubmissionReport& report);
void write_reports(const std::filesystem::path& folder, const ClassReport& report);

}
