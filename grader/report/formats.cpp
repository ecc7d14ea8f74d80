#include "report/formats.hpp"

#include <array>
#include <umbral/core/png.hpp>

#include "report/hidden.hpp"
#include "report/html/pages.hpp"
#include "report/json_text.hpp"

namespace umbral::grader {
namespace {

std::string student_page(const SubmissionReport& report)
{
    return html::report_from_sections(report.result, report.fingerprint, report.student_sections,
                                      {html::Edition::student, "", report.titles});
}

std::string instructor_page(const SubmissionReport& report)
{
    const html::ReportOptions options{html::Edition::instructor, "../index.html", report.titles};
    return html::report_from_sections(report.result, report.fingerprint, report.instructor_sections, options);
}

template <class Report>
void write_files(const std::filesystem::path& folder, const Report& report, std::span<const ReportFile<Report>> files)
{
    for (const ReportFile<Report>& file : files) {
        if (file.hidden_values && !report.with_hidden) {
            std::filesystem::remove(folder / file.name);
            continue;
        }
        const std::string text = file.text(report);
        write_file_atomically(folder / file.name, std::as_bytes(std::span(text)));
    }
}

}

std::span<const ReportFile<SubmissionReport>> submission_files()
{
    static constexpr std::array<ReportFile<SubmissionReport>, 4> files{{
        {"report.json", [](const SubmissionReport& report) { return report_json(report.result, report.fingerprint); }},
        {"report.student.json",
         [](const SubmissionReport& report) {
             return report_json(without_hidden_values(report.result), report.fingerprint);
         }},
        {"report.html", student_page},
        {"report.instructor.html", instructor_page, true},
    }};
    return files;
}

std::span<const ReportFile<ClassReport>> class_files()
{
    static constexpr std::array<ReportFile<ClassReport>, 2> files{{
        {"class.json", [](const ClassReport& report) { return class_json(report.result); }},
        {"index.html",
         [](const ClassReport& report) {
             return html::class_html(report.result, {report.titles, report.with_hidden});
         }},
    }};
    return files;
}

void write_reports(const std::filesystem::path& folder, const SubmissionReport& report)
{
    write_files(folder, report, submission_files());
}
void write_reports(const std::filesystem::path& folder, const ClassReport& report)
{
    write_files(folder, report, class_files());
}

}
