#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "figures.hpp"
#include "knee.hpp"
#include "law.hpp"
#include "overview.hpp"
#include "style.hpp"
#include "text/escape.hpp"

namespace umbral::bench {
namespace {

constexpr const char* definitions = R"(<details><summary>How to read this</summary><dl>
<dt>Time</dt><dd>Processor time, the shortest of many repetitions in which all settings take turns. Compare settings
with each other: the figures themselves hold for this machine only.</dd>
<dt>Front</dt><dd>Settings that no other beats in both time and error. The line joins them; all others are drawn
faintly.</dd>
<dt>Knee</dt><dd>The setting of the front farthest below the straight line from its cheapest to its dearest one,
with logarithmic axes (ringed). Up to there, doubling the time buys more accuracy than on average; beyond it, less.
Where the front has no bend there is no knee.</dd>
<dt>ulp</dt><dd>Unit in the last place: the distance between two neighbouring floats. No float can be nearer than half
of it to every number.</dd></dl></details>
)";

/// The curve of the first measure in a situation: the one whose front and knee the table marks.
const Curve* main_curve(const Knob& knob, const std::string& situation)
{
    const auto found = std::find_if(knob.curves.begin(), knob.curves.end(),
                                    [&](const Curve& curve) { return curve.situation == situation; });
    return found == knob.curves.end() ? nullptr : &*found;
}

std::string row_of(const Knob& knob, const Result& result, const Curve* curve, double shortest)
{
    const bool on_front =
        curve != nullptr && std::find(curve->front.begin(), curve->front.end(), result.setting) != curve->front.end();
    const bool is_knee = curve != nullptr && curve->knee == result.setting;
    std::string row =
        fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td><td>{}</td>",
                    is_knee    ? " class=\"knee\""
                    : on_front ? ""
                               : " class=\"quiet\"",
                    escape_html(result.setting), number_text(result.time), number_text(result.time / shortest));
    for (const Measure& measure : knob.measures)
        row += fmt::format("<td>{}</td>", number_text(result.errors.at(measure.id)));
    return row + fmt::format("<td class=\"word\">{}</td></tr>\n", is_knee ? "knee" : on_front ? "front" : "");
}

std::string table_of(const Knob& knob)
{
    std::string text = fmt::format(
        "<table><caption>{}: all settings</caption><thead><tr><th scope=\"col\">setting</th><th "
        "scope=\"col\">{}</th><th scope=\"col\">times the "
        "fastest</th>",
        escape_html(knob.title), escape_html(knob.time_unit));
    for (const Measure& measure : knob.measures)
        text += fmt::format("<th scope=\"col\">{}, {}</th>", escape_html(measure.name), escape_html(measure.unit));
    text += "<th scope=\"col\"></th></tr></thead>\n";
    for (const Situation& situation : knob.situations) {
        std::vector<Result> results = results_in(knob, situation.id);
        std::stable_sort(results.begin(), results.end(),
                         [](const Result& a, const Result& b) { return a.time < b.time; });
        text += "<tbody>";
        if (knob.situations.size() > 1)
            text += fmt::format("<tr class=\"situation\"><th scope=\"rowgroup\" colspan=\"{}\">{}</th></tr>\n",
                                knob.measures.size() + 4, escape_html(situation.label));
        for (const Result& result : results)
            text += row_of(knob, result, main_curve(knob, situation.id), results.front().time);
        text += "</tbody>";
    }
    return "<div class=\"scroll\">" + text + "</table></div>\n";
}

std::string figure_of(const Figure& figure)
{
    std::string text = "<figure>" + svg_of(figure.plot);
    if (figure.captions.empty())
        return text + fmt::format("<figcaption>{}</figcaption></figure>\n", escape_html(figure.plot.y_label));
    text += "<figcaption><ul>";
    for (const std::string& caption : figure.captions) text += fmt::format("<li>{}</li>", escape_html(caption));
    return text + "</ul></figcaption></figure>\n";
}

std::string section_of(const Knob& knob)
{
    std::string text =
        fmt::format("<section id=\"{0}\"><p class=\"up\"><a href=\"#\">All knobs</a></p><h2>{1}</h2>\n<p>{2}</p>\n",
                    escape_html(knob.id), escape_html(knob.title), escape_html(knob.text));
    const std::vector<Figure> figures = figures_of(knob);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        if (i == 1) text += "<div class=\"more\">";
        text += figure_of(figures[i]);
    }
    if (figures.size() > 1) text += "</div>";
    if (!knob.laws.empty()) {
        text += "<ul class=\"laws\">";
        for (const Law& law : knob.laws)
            text += fmt::format("<li class=\"{}\">{}</li>", law.verdict == "differs" ? "differs" : "agrees",
                                escape_html(sentence_of(knob, law)));
        text += "</ul>\n";
    }
    text += table_of(knob) + "<dl class=\"settings\">";
    // Descriptions that only count triangles stand in the table's order already: long lists say nothing.
    if (knob.settings.size() <= 8)
        for (const auto& [name, meaning] : knob.settings)
            text += fmt::format("<dt>{}</dt><dd>{}</dd>", escape_html(name), escape_html(meaning));
    return text + "</dl></section>\n";
}

}

std::string page_of(const Accuracy& accuracy)
{
    std::string text =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\">"
        "<meta name=\"color-scheme\" content=\"light dark\"><title>What accuracy costs in time</title>\n<style>";
    text += style_sheet;
    text +=
        "</style></head><body><header><p class=\"umbral\">Umbral</p><h1>What accuracy costs in time</h1>\n<p "
        "class=\"legend\">Error upwards, time to the right, both logarithmic. Ringed and named: the knee. Below it the "
        "fitted slope ± its 95 % interval, and theory’s: ✓ agrees, ≠ differs (the reason is a click away).</p>\n";
    text += overview_of(accuracy);
    text += definitions;
    if (accuracy.quick)
        text += "<p class=\"note\">Measured with --quick: few samples and settings. Figures are coarse.</p>";
    text += "</header><main>\n";
    for (const Knob& knob : accuracy.knobs) text += section_of(knob);
    text += fmt::format("</main><footer>{} · {}{}{}</footer></body></html>\n", escape_html(accuracy.processor),
                        escape_html(accuracy.compiler), accuracy.gl.empty() ? "" : " · ", escape_html(accuracy.gl));
    return text;
}

}
