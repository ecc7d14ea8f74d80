#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/scorecard.hpp"
#include "report/html/evidence.hpp"
#include "report/html/picture.hpp"

namespace umbral::grader::html {

/// Who reads a page: a student's shows no more of hidden checks than without_hidden_values leaves.
enum class Edition { student, instructor };

struct ReportOptions {
    Edition edition = Edition::student;
    std::string class_page;                       ///< relative link to the class's page; empty for none
    std::map<std::string, std::string> titles{};  ///< of units, by id; report_html takes them from its details
};

/// The report of one submission as one HTML file that needs nothing else: styles, scripts and pictures are in it, and
/// its policy forbids the browser to load anything. Readable without scripts, on paper, by keyboard and by a screen
/// reader.
///
/// A pure function of its arguments; all text in them is escaped. What `details` lacks is left out.
[[nodiscard]] std::string report_html(const SubmissionResult& submission, const Fingerprint& fingerprint,
                                      const UnitDetails& details, const ReportOptions& options = {});

/// One unit's section of a report, in one edition, as text that can be kept: report_from_sections puts it into a page,
/// wherever it stands there. All text in it is escaped.
[[nodiscard]] std::string section_html(const UnitResult& unit, const UnitDetail& detail, Edition edition);

/// The page that report_html makes, from sections made earlier: section_html's texts of this edition, one for each of
/// the submission's units, in their order. Throws std::invalid_argument if there are more or fewer.
[[nodiscard]] std::string report_from_sections(const SubmissionResult& submission, const Fingerprint& fingerprint,
                                               std::span<const std::string> sections,
                                               const ReportOptions& options = {});

struct ClassPageOptions {
    std::map<std::string, std::string> titles;  ///< of units, by id
    bool instructor_reports = false;            ///< link ID/report.instructor.html as well
};

/// The class at a glance: submissions by units, statistics of each unit, and who shares which explanation. Links
/// ID/report.html, ID/report.json and class.json, relative to itself.
[[nodiscard]] std::string class_html(const ClassResult& result, const ClassPageOptions& options = {});

/// What `umbral compare` found, as a page of one check.
struct Comparison {
    std::string yours;  ///< names of the two files
    std::string reference;
    CheckResult check;
    CheckDetail detail;
    std::vector<Explanation> reasons;  ///< why they do not agree, best first
    bool agree = false;
    std::string version;
};
[[nodiscard]] std::string comparison_html(const Comparison& comparison);

/// A unit as the catalogue shows it.
struct CatalogueEntry {
    std::string topic;
    std::string id;
    std::string title;
    Millipoints points = 0;
    std::vector<std::string> course;  ///< rows of the course
    std::string checked;              ///< what its checks look at, in words
    Picture goal;                     ///< empty where the unit has no picture
};

/// All units with the pictures that the reference draws for them, topic by topic in the order of `entries`.
[[nodiscard]] std::string catalogue_html(std::span<const CatalogueEntry> entries, const std::string& language,
                                         const std::string& version);

}
