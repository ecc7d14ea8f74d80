#include <algorithm>
#include <stdexcept>

#include "report/hidden.hpp"
#include "report/html/bars.hpp"
#include "report/html/document.hpp"
#include "report/html/sections.hpp"
#include "report/paint.hpp"
#include "report/reasons.hpp"

namespace umbral::grader::html {
namespace {

std::string headline(const SubmissionResult& submission)
{
    const auto right = static_cast<std::size_t>(std::ranges::count_if(submission.units, all_right));
    const auto faults = static_cast<std::size_t>(std::ranges::count_if(
        submission.units, [](const UnitResult& unit) { return unit.verdict == Verdict::grader_fault; }));
    const std::size_t all = submission.units.size();
    std::string text =
        all == 0       ? "No unit was graded."
        : right == all ? (all == 1 ? "Everything is right." : fmt::format("All {} units are right.", all))
        : right == 0   ? (all == 1 ? "Not right yet." : fmt::format("None of the {} units is right yet.", all))
                       : fmt::format("{} of {} units {} right.", right, all, right == 1 ? "is" : "are");
    if (faults > 0)
        text += fmt::format(" {} could not be graded, by a fault of the grader’s; {} not count.", faults,
                            faults == 1 ? "it does" : "they do");
    return text;
}

std::string title_of(const UnitResult& unit, const ReportOptions& options)
{
    const auto found = options.titles.find(unit.id);
    return found == options.titles.end() || found->second.empty() ? unit.id : found->second;
}

Markup unit_row(const UnitResult& unit, const ReportOptions& options, std::size_t number)
{
    const Verdict verdict = shown_verdict(unit);
    std::string sentences;
    for (const Explanation& reason : main_reasons(unit))
        sentences += (sentences.empty() ? "" : " Or: ") + reason.sentence;
    const Markup why = sentences.empty() ? Markup() : markup("<span class=\"in-short\">{}</span>", sentences);
    return markup(
        "<tr class=\"{}\"><th scope=\"row\"><a href=\"#u{}\">{}</a> <span class=\"id\">{}</span>{}</th><td>{}</td><td "
        "class=\"number\">{}<span class=\"of\"> / "
        "{}</span>{}"
        "</td></tr>\n",
        kind_of(verdict), number, title_of(unit, options), unit.id, why, verdict_chip(verdict), points_text(unit.score),
        points_text(unit.max_score), points_bar(unit.score, unit.max_score, kind_of(verdict)));
}

Markup summary(const SubmissionResult& submission, const ReportOptions& options)
{
    Markup rows;
    for (std::size_t i = 0; i < submission.units.size(); ++i) rows += unit_row(submission.units[i], options, i + 1);
    const bool hidden_fails = std::ranges::any_of(submission.units, [](const UnitResult& unit) {
        return !never_ran(unit.verdict) &&
               std::ranges::any_of(unit.checks, [](const CheckResult& check) { return check.hidden && fails(check); });
    });
    Markup result = markup("<section class=\"summary\" aria-labelledby=\"title\">\n<h1 id=\"title\">{}</h1>\n",
                           submission.id.empty() ? "Your units" : submission.id);
    result += markup("<p class=\"score\"><strong>{}</strong> of {} points</p>\n{}\n<p class=\"headline\">{}{}</p>\n",
                     points_text(submission.score), points_text(submission.max_score),
                     points_bar(submission.score, submission.max_score, "total"), headline(submission),
                     hidden_fails && options.edition == Edition::student
                         ? " Hidden checks fail too: of those you see what they look at."
                         : "");
    if (!submission.units.empty())
        result += scrolling("Units", markup("<table class=\"units\"><thead><tr><th scope=\"col\">Unit</th><th "
                                            "scope=\"col\">Verdict</th><th scope=\"col\" "
                                            "class=\"number\">Points</th></tr></thead>\n<tbody>\n{}</tbody></table>",
                                            rows));
    result += "</section>\n";
    return result;
}

SubmissionResult as_shown(const SubmissionResult& given, Edition edition)
{
    return edition == Edition::student ? without_hidden_values(given) : given;
}

std::string with_number(std::string_view section, std::size_t number)
{
    const std::string digits = std::to_string(number);
    std::string result;
    result.reserve(section.size() + 256);
    for (const char c : section)
        if (c == number_slot)
            result += digits;
        else
            result += c;
    return result;
}

}

std::string section_html(const UnitResult& unit, const UnitDetail& detail, Edition edition)
{
    const SubmissionResult shown = as_shown({.id = {}, .units = {unit}}, edition);
    return std::string(unit_section(shown.units.front(), detail, edition).view());
}

std::string report_html(const SubmissionResult& submission, const Fingerprint& fingerprint, const UnitDetails& details,
                        const ReportOptions& options)
{
    static const UnitDetail unknown;
    ReportOptions with_titles = options;
    std::vector<std::string> sections;
    for (const UnitResult& unit : submission.units) {
        const auto found = details.find(unit.id);
        const UnitDetail& detail = found == details.end() ? unknown : found->second;
        sections.push_back(section_html(unit, detail, options.edition));
        with_titles.titles.emplace(unit.id, detail.title);
    }
    return report_from_sections(submission, fingerprint, sections, with_titles);
}

std::string report_from_sections(const SubmissionResult& given, const Fingerprint& fingerprint,
                                 std::span<const std::string> sections, const ReportOptions& options)
{
    if (sections.size() != given.units.size())
        throw std::invalid_argument(fmt::format("a report of {} units: expected as many sections, got {}",
                                                given.units.size(), sections.size()));
    const SubmissionResult submission = as_shown(given, options.edition);
    Document document;
    document.title = (submission.id.empty() ? "Your units" : submission.id) + " – Umbral";
    const Markup home = options.class_page.empty()
                            ? Markup("<span class=\"brand\">Umbral</span>")
                            : markup("<a class=\"brand\" href=\"{}\">Umbral</a>", options.class_page);
    document.bar =
        markup("{}<span class=\"who\">{}{}</span><span class=\"brief\">{} / {}</span>{}{}", home, submission.id,
               options.edition == Edition::instructor ? " – instructor’s edition" : "", points_text(submission.score),
               points_text(submission.max_score), step_buttons(), theme_button());
    document.main = summary(submission, options);
    for (std::size_t i = 0; i < sections.size(); ++i) document.main += of_our_own(with_number(sections[i], i + 1));
    document.footer = fingerprint_footer(fingerprint);
    document.footer +=
        "<p class=\"keys\" data-script hidden>Keys: <kbd>j</kbd> <kbd>k</kbd> next and previous check, <kbd>b</kbd> "
        "blink, <kbd>t</kbd> light or dark.</p>";
    return document_html(document);
}

}
