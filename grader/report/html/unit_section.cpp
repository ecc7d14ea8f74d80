#include <algorithm>

#include "report/failing_order.hpp"
#include "report/hidden.hpp"
#include "report/html/bars.hpp"
#include "report/html/sections.hpp"
#include "report/paint.hpp"
#include "report/reruns.hpp"

namespace umbral::grader::html {
namespace {

/// `code`: columns matter, as in a compiler's message; otherwise long lines are broken.
Markup text_block(std::string_view heading, std::string_view text, bool code)
{
    if (text.empty()) return {};
    return markup("<h3>{}</h3>\n<pre tabindex=\"0\"{}>{}</pre>\n", heading, code ? Markup(" class=\"code\"") : Markup(),
                  text);
}

const char* heading_of_message(Verdict verdict)
{
    switch (verdict) {
        case Verdict::compile_error: return "What the compiler says";
        case Verdict::interface_mismatch: return "What the file defines, and what is expected";
        case Verdict::forbidden: return "What is not allowed here";
        case Verdict::missing:
        case Verdict::not_implemented: return "What was found";
        case Verdict::grader_fault: return "What went wrong on our side";
        case Verdict::ok:
        case Verdict::partial:
        case Verdict::wrong: return "Remarks";
        default: return "What stopped it";
    }
}

bool has_evidence(const CheckDetail& detail) { return !std::holds_alternative<std::monostate>(detail.evidence); }

/// The details of a unit's checks, as far as the edition may show them.
struct Details {
    const UnitDetail& unit;
    Edition edition;

    [[nodiscard]] const CheckDetail& of(const CheckResult& check) const
    {
        static const CheckDetail nothing;
        const auto& details = check.hidden && edition == Edition::student ? unit.practice : unit.checks;
        const auto found = details.find(check.name);
        return found == details.end() ? nothing : found->second;
    }
};

Markup in_a_row(const std::vector<const CheckResult*>& checks, const Details& details, std::string_view caption)
{
    if (checks.empty()) return {};
    Markup rows;
    for (const CheckResult* check : checks) {
        const CheckDetail& detail = details.of(*check);
        const Markup error =
            check->error ? markup("{}{}{}", short_number(*check->error), detail.unit.empty() ? "" : " ", detail.unit)
                         : Markup("–");
        const Markup hidden = check->hidden ? Markup(" <span class=\"tag\">hidden</span>") : Markup();
        rows += markup(
            "<tr class=\"{}\"><th scope=\"row\">{}{}</th><td>{}</td><td class=\"number\">{}<span class=\"of\"> / "
            "{}</span></td><td "
            "class=\"number\">{}</td><td>{}</td></tr>\n",
            fails(*check) ? "bad" : "ok", check->name, hidden, to_string(check->kind), points_text(check->score),
            points_text(check->max_score), error, detail.why);
    }
    return scrolling(caption, markup("<table class=\"checks\"><caption>{}</caption><thead><tr><th "
                                     "scope=\"col\">Check</th><th scope=\"col\">Judged as</th><th "
                                     "scope=\"col\" class=\"number\">Points</th><th scope=\"col\" "
                                     "class=\"number\">Error</th><th scope=\"col\">Where the "
                                     "tolerance comes from</th></tr></thead>\n<tbody>\n{}</tbody></table>",
                                     caption, rows));
}

Markup rubric_table(const UnitResult& unit)
{
    if (unit.rubric.empty()) return {};
    Markup rows;
    for (const RubricScore& line : unit.rubric)
        rows += markup(
            "<tr class=\"{}\"><th scope=\"row\">{}</th><td class=\"number\">{}<span class=\"of\"> / "
            "{}</span></td></tr>\n",
            line.score < line.max_score ? "bad" : "ok", line.words, points_text(line.score),
            points_text(line.max_score));
    return scrolling("Rubric", markup("<table class=\"rubric\"><caption>Rubric</caption><thead><tr><th "
                                      "scope=\"col\">Line</th><th scope=\"col\" "
                                      "class=\"number\">Points</th></tr></thead>\n<tbody>\n{}</tbody></table>",
                                      rows));
}

/// Checks in the order in which they help: failures, hidden failures, what is right.
struct Sorted {
    std::vector<const CheckResult*> articles;
    std::vector<const CheckResult*> hidden;
    std::vector<const CheckResult*> right;
};

Sorted sorted(const UnitResult& unit, const Details& details)
{
    Sorted result;
    for (const CheckResult& check : unit.checks) {
        const CheckDetail& known = details.of(check);
        const bool silent = check.hidden && check.message.empty() && check.practice.empty() &&
                            !check.practice_example && !has_evidence(known);
        if (fails(check) && !silent)
            result.articles.push_back(&check);
        else if (fails(check))
            result.hidden.push_back(&check);
        else
            result.right.push_back(&check);
    }
    std::ranges::stable_sort(result.articles, {}, failing_order);
    // One picture of a unit that is right: what it draws is worth a look.
    const auto shown =
        std::ranges::find_if(result.right, [&](const CheckResult* check) { return has_evidence(details.of(*check)); });
    if (result.articles.empty() && shown != result.right.end()) result.articles.push_back(*shown);
    return result;
}

}

Markup unit_section(const UnitResult& unit, const UnitDetail& detail, Edition edition)
{
    const Verdict verdict = shown_verdict(unit);
    const Markup number = "\x01";
    static_assert(number_slot == '\x01');
    Markup result = markup(
        "<section class=\"unit {0}\" id=\"u{1}\" aria-labelledby=\"u{1}-title\">\n<header><h2 id=\"u{1}-title\" "
        "tabindex=\"-1\">{2}</h2>\n<p "
        "class=\"id\">{3}</p>\n<p class=\"verdict\">{4} <span class=\"points\">{5}<span class=\"of\"> / {6} "
        "points</span></span></p></header>\n",
        kind_of(verdict), number, detail.title.empty() ? unit.id : detail.title, unit.id, verdict_chip(verdict),
        points_text(unit.score), points_text(unit.max_score));
    result += rubric_table(unit);
    result += why_section(unit.explanations);
    result += text_block(heading_of_message(verdict), unit.message, verdict == Verdict::compile_error);
    result += text_block("What the program printed", unit.output, false);
    if (never_ran(verdict)) {
        result += "</section>\n";
        return result;
    }
    result += time_bars(unit.seconds, unit.reference_seconds);
    if (unit.curve) result += curve_section(*unit.curve);
    const Details details{detail, edition};
    const Sorted checks = sorted(unit, details);
    for (std::size_t i = 0; i < checks.articles.size(); ++i)
        result += check_article(*checks.articles[i], details.of(*checks.articles[i]), markup("u{}-c{}", number, i + 1));
    result += in_a_row(checks.hidden, details, "Hidden checks that fail");
    result += in_a_row(checks.right, details,
                       checks.right.size() == unit.checks.size() ? "Every check is right" : "Checks that are right");
    result += markup("<p class=\"seed\">Random inputs of the visible cases: seed {}.</p>\n", unit.seed);
    for (const std::string& sentence : seeds_of_noise(unit)) result += markup("<p class=\"seed\">{}</p>\n", sentence);
    result += "</section>\n";
    return result;
}

}
