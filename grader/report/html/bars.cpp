#include "report/html/bars.hpp"

#include <algorithm>
#include <cmath>

namespace umbral::grader::html {
namespace {

constexpr double scale_width = 240;
constexpr double decades = 4;  // on either side of what is allowed

/// Where an error lies on the scale; errors beyond its ends lie at the ends.
double place(double error, double limit)
{
    if (!(error > 0)) return 4;
    const double share = std::clamp(std::log10(error / limit) / decades, -1.0, 1.0);
    return scale_width / 2 + share * (scale_width / 2 - 8);
}

std::string with_unit(double value, const std::string& unit)
{
    if (unit == "relative") return short_number(value) + " relative";
    return unit.empty() ? short_number(value) : short_number(value) + " " + unit;
}

}

std::string short_number(double value) { return fmt::format("{:.3g}", value); }

std::string seconds_text(double seconds)
{
    if (!std::isfinite(seconds)) return "–";
    if (seconds < 0.0995) return fmt::format("{:.2g} ms", 1000 * seconds);
    return seconds < 0.9995 ? fmt::format("{:.0f} ms", 1000 * seconds) : fmt::format("{:.3g} s", seconds);
}

Markup points_bar(long long score, long long max_score, std::string_view kind)
{
    constexpr double width = 100;
    double filled =
        max_score > 0 ? width * std::clamp(static_cast<double>(score) / static_cast<double>(max_score), 0.0, 1.0) : 0;
    // A little is seen as a little, and nearly all is not all.
    if (score > 0 && score < max_score) filled = std::clamp(filled, 3.0, width - 3);
    return markup(
        "<svg class=\"points-bar {}\" viewBox=\"0 0 100 6\" preserveAspectRatio=\"none\" aria-hidden=\"true\"><rect "
        "class=\"track\" width=\"100\" "
        "height=\"6\"/>"
        "<rect class=\"fill\" width=\"{:.1f}\" height=\"6\"/></svg>",
        kind, filled);
}

Markup time_bars(double yours, double reference)
{
    const double longest = std::max({yours, reference, 1e-9});
    Markup result = "<dl class=\"times\">";
    const auto line = [&](const char* name, const char* kind, double seconds) {
        const double width = std::isfinite(seconds) ? std::max(100 * seconds / longest, seconds > 0 ? 1.0 : 0.0) : 0;
        result += markup(
            "<div><dt>{}</dt><dd><svg viewBox=\"0 0 100 6\" preserveAspectRatio=\"none\" aria-hidden=\"true\"><rect "
            "class=\"{}\" width=\"{:.1f}\" "
            "height=\"6\"/></svg>"
            "<span>{}</span></dd></div>",
            name, kind, width, seconds_text(seconds));
    };
    line("your time", "of-yours", yours);
    line("reference", "of-reference", reference);
    result += "</dl>\n";
    return result;
}

Markup error_scale(const std::optional<double>& yours, const std::optional<double>& reference,
                   const CheckDetail& detail)
{
    if (!yours && !reference) return {};
    Markup words;
    if (yours) words += markup("<span class=\"of-yours\">your error {}</span>", with_unit(*yours, detail.unit));
    if (reference)
        words +=
            markup("<span class=\"of-reference\">the reference’s own {}</span>", with_unit(*reference, detail.unit));
    if (!detail.bound.empty()) words += markup("<span>allowed: {}</span>", detail.bound);

    Markup drawing;
    if (detail.limit && *detail.limit > 0) {
        drawing = markup(
            "<svg class=\"scale\" viewBox=\"0 0 240 28\" width=\"240\" height=\"28\" aria-hidden=\"true\"><rect "
            "class=\"allowed\" x=\"0\" y=\"12\" "
            "width=\"{0:.0f}\" "
            "height=\"4\"/><rect class=\"beyond\" x=\"{0:.0f}\" y=\"12\" width=\"{0:.0f}\" height=\"4\"/><path "
            "class=\"limit\" d=\"M{0:.0f} 5v18\"/>",
            scale_width / 2);
        if (reference)
            drawing += markup("<circle class=\"of-reference\" cx=\"{:.1f}\" cy=\"14\" r=\"4\"/>",
                              place(*reference, *detail.limit));
        if (yours)
            drawing += markup("<path class=\"of-yours\" d=\"M{:.1f} 8l6 6-6 6-6-6z\"/>",
                              std::clamp(place(*yours, *detail.limit), 7.0, scale_width - 7));
        drawing += "</svg>";
    }
    return markup("<div class=\"errors\">{}<p>{}</p></div>\n", drawing, words);
}

}
