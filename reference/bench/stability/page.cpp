#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../accuracy/style.hpp"
#include "inputs.hpp"
#include "text/escape.hpp"

namespace stability {
namespace {

using umbral::escape_html;

constexpr const char* own_style = R"css(
body { max-width: 74rem; }
.row { display: grid; grid-template-columns: minmax(22rem, 1fr) 5.5rem 5.5rem 5.5rem 5.5rem 8.5rem 7rem;
  gap: .2rem 1rem;
  align-items: center; font-variant-numeric: tabular-nums; font-size: .9rem; }
.row > * { text-align: right; } .row > :first-child, .row > :last-child { text-align: left; }
.row.head { color: var(--soft); padding: .4rem 1.1rem; border-bottom: 1px solid var(--edge); font-size: .82rem; }
details.one { max-width: none; border-bottom: 1px solid var(--edge); padding: .35rem 1.1rem; background: var(--card); }
details.one summary { color: var(--ink); list-style: none; }
details.one summary::-webkit-details-marker { display: none; }
details.one summary code { font-weight: 600; }
details.one summary code::before { content: "▸ "; color: var(--soft); }
details.one[open] summary code::before { content: "▾ "; }
.bar { display: block; height: .55rem; border-radius: 4px; background: var(--minor); overflow: hidden; }
.bar i { display: block; height: 100%; background: var(--c2); }
.bad { color: var(--c1); font-weight: 600; } .bar.over i { background: var(--c1); }
pre { white-space: pre-wrap; overflow-wrap: anywhere; background: var(--minor); padding: .7rem .9rem;
  border-radius: 8px;
  font-size: .82rem; margin: .5rem 0; }
.values td { padding: .15rem 1rem .15rem 0; vertical-align: top; overflow-wrap: anywhere; }
.values td:first-child { color: var(--soft); white-space: nowrap; }
.big { font-size: 1.6rem; font-weight: 700; display: block; }
td, th { padding: .3rem .8rem .3rem 0; text-align: left; border-bottom: 1px solid var(--edge); }
)css";

std::string figure(double value)
{
    return std::isfinite(value) ? fmt::format("{:.3g}", value) : std::string("no number");
}

std::string values(const Answer& answer)
{
    std::string text;
    for (const float value : answer) text += fmt::format("{}{}", text.empty() ? "" : ", ", value);
    return text.empty() ? "nothing" : text;
}

std::string question(const char* title, const Result& one, const std::vector<float>& x, const Answer& naive,
                     const Answer* reference, const Answer& oracle)
{
    if (x.empty()) return "";
    std::string html = fmt::format("<p class=note>{}</p><pre><code>{}</code></pre><table class=values>", title,
                                   escape_html(code_of(one.call, x)));
    const auto line = [&](const char* who, const Answer& answer) {
        html += fmt::format("<tr><td>{}</td><td>{}</td></tr>", who, values(answer));
    };
    if (one.row.naive != nullptr) line("textbook's formula", naive);
    if (reference != nullptr) line("reference", *reference);
    line("oracle", oracle);
    return html + "</table>";
}

std::string row_of(const Result& one)
{
    const bool naive = one.row.naive != nullptr;
    const double share = std::clamp(one.used, 0.0, 1.0);
    std::string html = fmt::format(
        "<details class=one><summary class=row><code>{}</code><span>{}</span><span{}>{}</span><span>{}</span>"
        "<span{}>{}</span><span>{} {}</span><span class=\"bar{}\" title=\"{:.0f} % of what it may be off\">"
        "<i style=\"width:{:.0f}%\"></i></span></summary>",
        escape_html(one.row.name), naive ? figure(one.naive.median) : "–", one.naive_exceeds ? " class=bad" : "",
        naive ? figure(one.naive.worst) : "–", figure(one.reference.median), failed(one) ? " class=bad" : "",
        figure(one.reference.worst), figure(one.row.bound),
        one.row.unit == Unit::absolute ? ""
        : one.row.unit == Unit::ulps   ? "ulp"
                                       : "ulp (largest)",
        failed(one) ? " over" : "", 100 * one.used, 100 * share);
    html += fmt::format("<p class=note>The bound: {}. Counted in: {}. {} questions had a finite answer.</p>",
                        escape_html(one.row.reason), unit_text(one.row.unit), one.asked);
    html += question("Where the reference is nearest to its bound:", one, one.worst, one.naive_answer,
                     &one.reference_answer, one.oracle_answer);
    if (naive && one.naive.worst > 0)
        html += question("Where the textbook's formula is worst:", one, one.naive_worst, one.naive_worst_answer,
                         nullptr, one.naive_worst_oracle);
    return html + "</details>\n";
}

std::string sweeps_of(const std::vector<SweepResult>& sweeps)
{
    std::string html =
        "<section><h2>What must hold whatever is right</h2><p>The same question changed: scaled, negated, its axes or "
        "its arguments exchanged, moved far away.</p><table><tr><th>Function<th>Relation<th>Worst, in ulp of the "
        "largest<th>Allowed</tr>";
    for (const SweepResult& one : sweeps)
        html += fmt::format("<tr><td><code>{}</code><td>{}<td{}>{}<td>{}</tr>", escape_html(one.relation.function),
                            one.relation.holds, failed(one) ? " class=bad" : "", figure(one.worst),
                            one.relation.ulps == 0 ? "0: exact" : figure(one.relation.ulps));
    return html + "</table></section>";
}

std::string finite_of(const FiniteResult& finite)
{
    std::string html = fmt::format(
        "<section><h2>Finite in, finite out</h2><p>{} questions of 0, -0, the smallest float, ±1e±30, equal and "
        "opposite "
        "vectors, to {} functions: {} were refused by an exception, {} have a right answer larger than every float, "
        "and NaN or infinity left {} functions otherwise.</p>",
        finite.asked, finite.functions, finite.refused, finite.overflowed, finite.escapes.size());
    for (const Escape& one : finite.escapes) html += "<pre class=bad>" + escape_html(one.code) + "</pre>";
    return html + "</section>";
}

}

bool failed(const Result& result) { return result.asked == 0 || !(result.used <= 1); }
bool failed(const SweepResult& result) { return result.asked == 0 || !(result.worst <= result.relation.ulps); }

std::string page_of(const Measured& measured)
{
    const auto count = [&](auto which) { return std::ranges::count_if(measured.results, which); };
    const auto within = count([](const Result& one) { return !failed(one); });
    const auto broken = count([](const Result& one) { return one.naive_exceeds; });
    const auto naive = count([](const Result& one) { return one.row.naive != nullptr; });
    std::string html = fmt::format(
        "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport content=\"width=device-width\">"
        "<title>Numerical stability</title><style>{}{}</style><p class=umbral>Umbral</p><h1>Hard cases stay "
        "numerically stable</h1><ul class=answers><li><span class=big>{} of {}</span>functions keep the bound that "
        "their header promises</li><li><span class=big>{} of {}</span>textbook formulas in float break it</li></ul>"
        "<p>Each function answered {} questions with numbers from 1e-8 to 1e8, nearly parallel, equal, opposite and "
        "cancelling ones among them (seed {}); the oracle computes in 113 bits and rounds once, for which half an ulp "
        "is allowed besides. A row opens its worst questions.</p>",
        umbral::bench::style_sheet, own_style, within, measured.results.size(), broken, naive, measured.questions,
        measured.seed);
    html +=
        "<section><div class=\"row head\"><span>Function</span><span>textbook, median</span><span>textbook, "
        "worst</span>"
        "<span>reference, median</span><span>reference, worst</span><span>bound</span><span>used of the bound</span>"
        "</div>\n";
    for (const Result& one : measured.results) html += row_of(one);
    return html + "</section>" + sweeps_of(measured.sweeps) + finite_of(measured.finite) + "</html>\n";
}

}
