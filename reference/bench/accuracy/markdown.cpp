#include "markdown.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "knee.hpp"
#include "overview.hpp"

namespace umbral::bench {
namespace {

/// What a text is in a table's cell: no bars.
std::string cell(std::string text)
{
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
}

/// One sentence a line.
std::string sentences(std::string text)
{
    for (std::size_t at = 0; (at = text.find(". ", at)) != std::string::npos; at += 4) text.replace(at, 2, ".\n  ");
    return text;
}

/// What the knee buys: the error's and the time's ratio to the cheapest setting of the front.
std::string bought(const Knob& knob)
{
    const Curve& curve = main_curve_of(knob);
    if (curve.front.empty()) return "";
    const auto result = [&](const std::string& setting) {
        const std::vector<Result> results = results_in(knob, curve.situation);
        return *std::find_if(results.begin(), results.end(), [&](const Result& one) { return one.setting == setting; });
    };
    const std::string& end = curve.knee ? *curve.knee : curve.front.back();
    const Result first = result(curve.front.front());
    const Result last = result(end);
    const double before = first.errors.at(curve.measure);
    const double after = last.errors.at(curve.measure);
    const std::string unit = measure_of(knob, curve.measure).unit;
    return fmt::format("{} → {} {} for {} times the time", number_text(before), number_text(after), unit,
                       number_text(last.time / first.time));
}

}

std::string markdown_of(const Accuracy& accuracy)
{
    std::string text = fmt::format(
        "# What accuracy costs in time\n\nMade by `umbral bench accuracy --markdown{}`, on {}, {}. Definitions and the "
        "large plots are on the page\nthat the same command writes; all figures are in its JSON "
        "([schema](schemas/accuracy.schema.json)).\n\n"
        "![One card for each knob, with its curve of error against time, its knee and its slope](pictures/"
        "accuracy.png)\n\n",
        accuracy.quick ? " --quick" : "", accuracy.processor, accuracy.compiler);
    text +=
        "The knee is the setting beyond which time buys less than on average; without a bend the dearest setting of "
        "the "
        "front\nstands there. Slopes are fitted to the logarithms, with 95 % confidence intervals from their scatter. "
        "✓ says\nthat theory's order, on the right, lies within the interval, or within 0.1 (a tenth of "
        "orders "
        "above 1);\n≠ that it does not, and the reason stands below; ? that too few points, or too scattered ones, "
        "tell "
        "nothing.\n\n"
        "| knob | error | knee | what it buys | slope, and theory's |\n|---|---|---|---|---|\n";
    for (const Knob& knob : accuracy.knobs) {
        if (knob.curves.empty()) continue;
        const Curve& curve = main_curve_of(knob);
        std::string slopes;
        for (const Law& law : knob.laws)
            slopes += fmt::format("{}{}{}", slopes.empty() ? "" : "<br>", law.family.empty() ? "" : law.family + ": ",
                                  slope_text(law));
        const std::string where =
            knob.situations.size() > 1 ? " (" + situation_of(knob, curve.situation).label + ")" : "";
        text += fmt::format(
            "| {} | {}{} | {} | {} | {} |\n", cell(knob.title), cell(measure_of(knob, curve.measure).name), cell(where),
            cell(curve.knee.value_or("no bend: " + curve.front.back())), cell(bought(knob)), cell(slopes));
    }
    text += "\n## Why slopes differ\n\n";
    for (const Knob& knob : accuracy.knobs)
        for (const Law& law : knob.laws)
            if (law.verdict == "differs")
                text += fmt::format("- **{}**, {}:\n  {}\n", knob.title, law.family, sentences(law.reason));
    return text;
}

}
