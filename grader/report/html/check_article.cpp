#include <fmt/format.h>

#include <array>
#include <cctype>
#include <utility>

#include "judge/judges.hpp"
#include "report/check_words.hpp"
#include "report/html/bars.hpp"
#include "report/html/sections.hpp"
#include "report/layout.hpp"
#include "report/paint.hpp"

namespace umbral::grader::html {
namespace {

struct MetricName {
    const char* key;
    const char* name;
    const char* unit;
};

/// What people know about pictures; the other figures of a judge stand in report.json.
constexpr std::array picture_metrics = {MetricName{"ssim", "SSIM", ""},
                                        MetricName{"psnr", "PSNR", " dB"},
                                        MetricName{"rmse", "RMSE", " levels"},
                                        MetricName{"mean_delta_e", "mean ΔE", ""},
                                        MetricName{"max_delta_e", "largest ΔE", ""},
                                        MetricName{"probability", "chance of noise alone", ""},
                                        MetricName{"misplaced_percent", "light in the wrong place", " %"}};

Markup metrics(const CheckResult& check)
{
    Markup list;
    for (const MetricName& metric : picture_metrics)
        if (const auto found = check.metrics.find(metric.key); found != check.metrics.end())
            list += markup("<div><dt>{}</dt><dd>{:.4g}{}</dd></div>", metric.name, found->second, metric.unit);
    return list.empty() ? Markup() : markup("<dl class=\"metrics\">{}</dl>\n", list);
}

Markup first_difference(const CheckResult& check)
{
    if (!check.first_difference) return {};
    const Difference& first = *check.first_difference;
    return markup(
        "<dl class=\"first\"><div><dt>first at</dt><dd>{}</dd></div><div "
        "class=\"of-yours\"><dt>yours</dt><dd>{}</dd></div><div "
        "class=\"of-reference\"><dt>expected</dt>"
        "<dd>{}</dd></div></dl>\n",
        first.where, first.yours, first.expected);
}

/// A question as code below a sentence; nothing if it is not known.
Markup asked_code(const std::string& sentence, const std::string& code)
{
    if (code.empty()) return {};
    return markup("<p class=\"question\">{}</p>\n<pre class=\"question\"><code>{}</code></pre>\n", sentence, code);
}

Markup question(const CheckResult& check)
{
    if (!check.first_difference) return {};
    return asked_code(fmt::format("At {} this was asked:", check.first_difference->where),
                      check.first_difference->question);
}

/// Where lists and files in the question stand with all their elements.
Markup question_in_full(const CheckResult& check)
{
    const auto found = check.artefacts.find("question");
    if (found == check.artefacts.end()) return {};
    return markup("<p class=\"note\">The first question in full: <code>{}</code></p>\n", found->second);
}

/// A question that is none of those behind the check's evidence, and what came of it.
Markup wrong_question(const char* title, const std::optional<Difference>& wrong)
{
    if (!wrong) return {};
    const Markup code = wrong->question.empty() ? Markup() : markup("<pre><code>{}</code></pre>\n", wrong->question);
    const Markup where = wrong->where.empty() ? Markup() : markup("<div><dt>at</dt><dd>{}</dd></div>", wrong->where);
    return markup(
        "<div class=\"simplest\"><h4>{}</h4>\n{}<dl class=\"first\">{}<div class=\"of-yours\"><dt>yours</dt><dd>{}</dd>"
        "</div><div class=\"of-reference\"><dt>expected</dt><dd>{}</dd></div></dl></div>\n",
        title, code, where, wrong->yours, wrong->expected);
}

/// With a capital letter and a full stop.
std::string sentence(std::string text)
{
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text + ".";
}

/// The line of the student's own file where wrong answers part from right ones.
Markup code_place(const CheckResult& check)
{
    if (!check.code_place) return {};
    const CodePlace& place = *check.code_place;
    const std::string mark =
        place.column > 1
            ? "\n" +
                  std::string(static_cast<std::size_t>(display_width(
                                  std::string_view(place.text).substr(0, static_cast<std::size_t>(place.column) - 1))),
                              ' ') +
                  "^"
            : "";
    return markup(
        "<div class=\"simplest\"><h4>Where wrong answers part from right ones: {}, line "
        "{}</h4>\n<pre><code>{}{}</code></pre>\n"
        "<p>{}</p></div>\n",
        place.file, place.line, place.text, mark,
        sentence(check.hidden ? "on practice inputs, " + place.sentence : place.sentence));
}

struct Show {
    const Markup& anchor;

    Markup operator()(const std::monostate&) const { return {}; }
    Markup operator()(const PictureEvidence& evidence) const { return picture_evidence(evidence, anchor); }
    Markup operator()(const RowsEvidence& evidence) const { return rows_evidence(evidence); }
    Markup operator()(const LinesEvidence& evidence) const { return lines_evidence(evidence); }
    Markup operator()(const FragmentsEvidence& evidence) const { return fragments_evidence(evidence); }
    Markup operator()(const CostEvidence& evidence) const { return cost_evidence(evidence); }
};

/// The evidence shows the values.
std::string_view shown_message(const CheckResult& check, const CheckDetail& detail)
{
    const bool shows_values = std::holds_alternative<RowsEvidence>(detail.evidence);
    return shows_values && !check.headline.empty() ? check.headline : check.message;
}

}

Markup check_article(const CheckResult& check, const CheckDetail& detail, const Markup& anchor, bool with_points)
{
    const bool right = check.score >= check.max_score;
    const char* kind = right ? "ok" : check.score > 0 ? "partial" : "bad";
    Markup result = markup(
        "<article class=\"check {0}\" id=\"{1}\" tabindex=\"-1\" aria-labelledby=\"{1}-name\" data-check>\n<header><h3 "
        "id=\"{1}-name\">{2}</h3>\n<p>",
        kind, anchor, check.name);
    if (check.hidden) result += "<span class=\"tag\">hidden</span> ";
    if (check.hard) result += "<span class=\"tag\">hard case</span> ";
    result += markup("<span class=\"tag\">{}</span>", to_string(check.kind));
    if (with_points)
        result += markup(" <span class=\"points\">{}, {}<span class=\"of\"> / {} points</span></span>",
                         check_words(check), points_text(check.score), points_text(check.max_score));
    result += "</p></header>\n";
    if (!check.about.empty()) result += markup("<p class=\"about\"><span>Looks at:</span> {}</p>\n", check.about);
    if (!check.message.empty()) result += markup("<p class=\"message\">{}</p>\n", shown_message(check, detail));
    result += asked_code("Its case ended in this question:", check.last_question);
    if (!check.common.empty()) result += markup("<p class=\"common\">{}</p>\n", sentence(check.common));
    if (!check.practice.empty())
        result += markup("<p class=\"common\">{}</p>\n", sentence("on practice inputs: " + check.practice));
    if (!check.depends.empty())
        result += markup("<p class=\"common\">{}</p>\n",
                         sentence((check.hidden ? "on practice inputs, " : "") + check.depends));
    result += code_place(check);
    result += wrong_question("A wrong value on practice inputs", check.practice_example);
    result += wrong_question("The simplest question with a wrong answer", check.simplest);
    if (std::holds_alternative<std::monostate>(detail.evidence)) result += first_difference(check);
    if (!std::holds_alternative<RowsEvidence>(detail.evidence)) result += question(check);
    if (detail.practice) result += Markup("<h4>On practice inputs</h4>\n");
    result += std::visit(Show{anchor}, detail.evidence);
    result += question_in_full(check);
    if (judge_of(check).look != Look::none)
        result += metrics(check);
    else
        result += error_scale(check.error, check.reference_error, detail);
    if (!detail.why.empty())
        result += markup("<p class=\"tolerance\"><span>Where the tolerance comes from:</span> {}</p>\n", detail.why);
    result += "</article>\n";
    return result;
}

}
