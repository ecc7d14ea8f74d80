#include <algorithm>

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
    const auto faults =
        static_cast<std::size_t>(std::ranges::count_if(submission.units, [](const UnitResult& unit) { return unit.verdict == Verdict::grader_fault; }));
    const std::size_t all = submission.units.size();
    std::string text = all == 0       ? "No unit was graded."
                       : right == all ? (all == 1 ? "Everything is right." : fmt::format("All {} units are right.", all))
                       : right == 0   ? (all == 1 ? "Not right yet." : fmt::format("None of the {} units is right yet.", all))
                                      : fmt::format("{} of {} units {} right.", right, all, right == 1 ? "is" : "are");
    if (faults > 0) text += fmt::format(" {} could not be graded, by a fault of the grader’s; {} not count.", faults, faults == 1 ? "it does" : "they do");
    return text;
}

std::string title_of(const UnitResult& unit, const Gallery& gallery)
{
    const auto found = gallery.find(unit.id);
    return found == gallery.end() || found->second.title.empty() ? unit.id : found->second.title;
}

Markup unit_row(const UnitResult& unit, const Gallery& gallery, std::size_t number)
{
    const Verdict verdict = shown_verdict(unit);
    std::string sentences;
    for (const Explanation& reason : main_reasons(unit)) sentences += (sentences.empty() ? "" : " Or: ") + reason.sentence;
    const Markup why = sentences.empty() ? Markup() : markup("<span class=\"in-short\">{}</span>", sentences);
    return markup(
        "<tr class=\"{}\"><th scope=\"row\"><a href=\"#u{}\">{}</a> <span class=\"id\">{}</span>{}</th><td>{}</td><td class=\"number\">{}<span class=\"of\"> / "
        "{}</span>{}"
        "</td></tr>\n",
        kind_of(verdict), number, title_of(unit, gallery), unit.id, why, verdict_chip(verdict), points_text(unit.score), points_text(unit.max_score),
        points_bar(unit.score, unit.max_score, kind_of(verdict)));
}

Markup summary(const SubmissionResult& submission, const Gallery& gallery, const ReportOptions& options)
{
    Markup rows;
    for (std::size_t i = 0; i < submission.units.size(); ++i) rows += unit_row(submission.units[i], gallery, i + 1);
    const bool hidden_fails = std::ranges::any_of(submission.units, [](const UnitResult& unit) {
        return !never_ran(unit.verdict) &&
               std::ranges::any_of(unit.checks, [](const CheckResult& check) { return check.hidden && check.score < check.max_score; });
    });
    Markup result =
        markup("<section class=\"summary\" aria-labelledby=\"title\">\n<h1 id=\"title\">{}</h1>\n", submission.id.empty() ? "Your units" : submission.id);
    result += markup("<p class=\"score\"><strong>{}</strong> of {} points</p>\n{}\n<p class=\"headline\">{}{}</p>\n", points_text(submission.score),
                     points_text(submission.max_score), points_bar(submission.score, submission.max_score, "total"), headline(submission),
                     hidden_fails && options.edition == Edition::student ? " Hidden checks fail too: of those you see the name." : "");
    if (!submission.units.empty())
        result += scrolling("Units", markup("<table class=\"units\"><thead><tr><th scope=\"col\">Unit</th><th scope=\"col\">Verdict</th><th scope=\"col\" "
                                            "class=\"number\">Points</th></tr></thead>\n<tbody>\n{}</tbody></table>",
                                            rows));
    result += "</section>\n";
    return result;
}

}

std::string report_html(const SubmissionResult& given, const Fingerprint& fingerprint, const Gallery& gallery, const ReportOptions& options)
{
    const SubmissionResult submission = options.edition == Edition::student ? without_hidden_values(given) : given;
    Document document;
    document.title = (submission.id.empty() ? "Your units" : submission.id) + " – Umbral";
    const Markup home =
        options.class_page.empty() ? Markup("<span class=\"brand\">Umbral</span>") : markup("<a class=\"brand\" href=\"{}\">Umbral</a>", options.class_page);
    document.bar = markup("{}<span class=\"who\">{}{}</span><span class=\"brief\">{} / {}</span>{}{}", home, submission.id,
                          options.edition == Edition::instructor ? " – instructor’s edition" : "", points_text(submission.score),
                          points_text(submission.max_score), step_buttons(), theme_button());
    document.main = summary(submission, gallery, options);
    static const UnitDetail unknown;
    for (std::size_t i = 0; i < submission.units.size(); ++i) {
        const auto found = gallery.find(submission.units[i].id);
        document.main += unit_section(submission.units[i], found == gallery.end() ? unknown : found->second, i + 1, options.edition);
    }
    document.footer = fingerprint_footer(fingerprint);
    document.footer +=
        "<p class=\"keys\" data-script hidden>Keys: <kbd>j</kbd> <kbd>k</kbd> next and previous check, <kbd>b</kbd> blink, <kbd>t</kbd> light or dark.</p>";
    return document_html(document);
}

}
