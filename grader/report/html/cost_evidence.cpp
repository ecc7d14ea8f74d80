#include <algorithm>
#include <cmath>

#include "report/html/bars.hpp"
#include "report/html/sections.hpp"

namespace umbral::grader::html {
namespace {

constexpr double plot_left = 52;
constexpr double plot_right = 428;
constexpr double plot_top = 14;
constexpr double plot_bottom = 232;

/// A logarithmic axis over whole decades.
struct Axis {
    double low = 0;  ///< exponents of ten
    double high = 1;
    double from = 0;
    double to = 1;

    [[nodiscard]] double at(double value) const
    {
        return from + (std::log10(value) - low) / (high - low) * (to - from);
    }
};

Axis axis_for(double least, double most, double from, double to)
{
    Axis axis{std::floor(std::log10(least)), std::ceil(std::log10(most)), from, to};
    if (axis.high <= axis.low) axis.high = axis.low + 1;
    return axis;
}

struct Extent {
    double least = INFINITY;
    double most = 0;

    void include(double value)
    {
        if (!(value > 0) || !std::isfinite(value)) return;
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

/// "2,700,055": counts are whole.
std::string count_text(double value)
{
    if (!(std::abs(value) < 1e15)) return short_number(value);
    std::string text = fmt::format("{:.0f}", value);
    for (std::size_t at = text.size(); at > 3 && text[at - 4] != '-'; at -= 3) text.insert(at - 3, ",");
    return text;
}

/// A power of ten as an axis is labelled.
Markup power_of_ten(double exponent)
{
    if (exponent >= 0 && exponent <= 3) return escaped(count_text(std::pow(10.0, exponent)));
    return markup("10<tspan dy=\"-4\" font-size=\"8\">{:.0f}</tspan>", exponent);
}

Markup grid(const Axis& across, const Axis& up)
{
    Markup result;
    for (double e = across.low; e <= across.high + 0.5; ++e) {
        const double x = across.at(std::pow(10.0, e));
        result += markup(
            "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text x=\"{0:.1f}\" y=\"{3}\" "
            "text-anchor=\"middle\">{4}</text>",
            x, plot_top, plot_bottom, plot_bottom + 17, power_of_ten(e));
    }
    for (double e = up.low; e <= up.high + 0.5; ++e) {
        const double y = up.at(std::pow(10.0, e));
        result += markup(
            "<path class=\"grid\" d=\"M{1} {0:.1f}H{2}\"/><text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>",
            y, plot_left, plot_right, plot_left - 7, y + 4, power_of_ten(e));
    }
    return result;
}

template <class Choose>
Markup curve(const CostEvidence& evidence, const Axis& across, const Axis& up, const char* kind, Choose choose)
{
    std::string path;
    Markup dots;
    for (const CostPoint& point : evidence.points) {
        const std::optional<double> value = choose(point);
        if (!value || !(*value > 0) || !std::isfinite(*value) || !(point.size > 0)) continue;
        const double x = across.at(point.size);
        const double y = up.at(*value);
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
        dots += markup("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\"/>", kind, x, y);
    }
    return markup("<path class=\"curve {}\" d=\"{}\"/>{}", kind, path, dots);
}

Markup table(const CostEvidence& evidence)
{
    Markup rows;
    const auto cell = [](const std::optional<double>& value) { return value ? count_text(*value) : std::string("–"); };
    for (const CostPoint& point : evidence.points)
        rows += markup(
            "<tr><th scope=\"row\" class=\"number\">{}</th><td class=\"number of-yours\">{}</td><td class=\"number "
            "of-reference\">{}</td></tr>\n",
            count_text(point.size), cell(point.yours), cell(point.reference));
    return scrolling("Work by size",
                     markup("<table class=\"rows\"><caption>Basic blocks executed</caption><thead><tr><th "
                            "scope=\"col\" class=\"number\">size</th><th scope=\"col\" "
                            "class=\"number of-yours\">yours</th><th scope=\"col\" class=\"number "
                            "of-reference\">reference</th></tr></thead>\n<tbody>\n{}</tbody></table>",
                            rows));
}

}

Markup cost_evidence(const CostEvidence& evidence)
{
    Extent sizes;
    Extent counts;
    for (const CostPoint& point : evidence.points) {
        sizes.include(point.size);
        counts.include(point.yours.value_or(0));
        counts.include(point.reference.value_or(0));
    }
    if (!(sizes.most > 0) || !(counts.most > 0)) return table(evidence);
    const Axis across = axis_for(sizes.least, sizes.most, plot_left, plot_right);
    const Axis up = axis_for(counts.least, counts.most, plot_bottom, plot_top);
    return markup(
        "<div class=\"cost\"><figure><figcaption>work over size, both axes logarithmic</figcaption><svg class=\"plot\" "
        "viewBox=\"0 0 440 268\" role=\"img\" "
        "aria-label=\"Basic blocks "
        "over the size of the problem: yours and the reference; the table beside it has the numbers\">{}{}{}<text "
        "x=\"{}\" y=\"{}\" "
        "text-anchor=\"middle\">size</text></svg><p "
        "class=\"legend\"><span class=\"of-yours\">yours</span> <span class=\"of-reference\">reference</span> <span>it "
        "may grow like the size to the power "
        "{:.3g}</span></p></figure>\n{}</div>\n",
        grid(across, up),
        curve(evidence, across, up, "of-reference", [](const CostPoint& point) { return point.reference; }),
        curve(evidence, across, up, "of-yours", [](const CostPoint& point) { return point.yours; }),
        (plot_left + plot_right) / 2, plot_bottom + 34, evidence.growth, table(evidence));
}

}
