#include <algorithm>
#include <cmath>

#include "report/curve_places.hpp"
#include "report/curve_words.hpp"
#include "report/html/sections.hpp"

namespace umbral::grader::html {
namespace {

// The picture and, within it, the frame in which points lie.
constexpr double width = 460;
constexpr double height = 260;
constexpr double left = 90;
constexpr double right = width - 16;
constexpr double top = 16;
constexpr double bottom = height - 44;
constexpr double inset = 22;  ///< between frame and points

struct Spot {
    double x;
    double y;
};

struct Box {
    double left, top, right, bottom;
    [[nodiscard]] bool meets(const Box& other) const
    {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

Spot spot_of(const CurvePlace& place)
{
    return {left + inset + place.x * (right - left - 2 * inset), bottom - inset - place.y * (bottom - top - 2 * inset)};
}

/// Where a point's name stands: beside it, on the first side where it covers nothing; or farther above, where a line
/// leads to it; below it if there is no room either.
Spot place_of_name(const Spot& spot, std::size_t letters, std::vector<Box>& taken)
{
    const double wide = 6.6 * static_cast<double>(letters);
    const auto box = [&](double x, double y) { return Box{x, y - 11, x + wide, y + 4}; };
    const double inside = std::clamp(spot.x - wide / 2, left + 4, std::max(left + 4, right - 4 - wide));
    const std::initializer_list<Spot> sides = {{spot.x + 11, spot.y + 4},  {spot.x - 11 - wide, spot.y + 4},
                                               {inside, spot.y - 12},      {inside, spot.y + 22},
                                               {spot.x + 11, spot.y + 18}, {spot.x + 11, spot.y - 10},
                                               {inside, spot.y - 30},      {inside, spot.y - 46},
                                               {inside, spot.y - 62},      {inside, spot.y - 78}};
    for (const Spot& one : sides) {
        const Box here = box(one.x, one.y);
        const bool within = here.left > left && here.right < right && here.top > top && here.bottom < bottom;
        if (!within || std::ranges::any_of(taken, [&](const Box& other) { return here.meets(other); })) continue;
        taken.push_back(here);
        return one;
    }
    return {inside, spot.y + 22};
}

/// The line from a point to its name that stands farther above.
Markup leader(const Spot& spot, const Spot& name)
{
    constexpr double beside = 24;
    if (spot.y - name.y < beside) return {};
    return markup("<path class=\"leader\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", spot.x, spot.y - 8, name.y + 5);
}

/// Characters, of which names have few that take more than a byte.
std::size_t letters_of(std::string_view text)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// A name that has room in the picture; the table has all of it.
std::string in_short(const std::string& name)
{
    constexpr std::size_t most = 24;
    if (name.size() <= most) return name;
    std::size_t size = most;
    while (size > 0 && (static_cast<unsigned char>(name[size]) & 0xC0U) == 0x80U) --size;
    return name.substr(0, size) + "…";
}

Markup axes(const UnitCurve& curve, const std::vector<CurvePoint>& points, const std::vector<CurvePlace>& places)
{
    Markup result = markup("<path class=\"frame\" d=\"M{0:.0f} {1:.0f}V{2:.0f}H{3:.0f}\"/>", left, top, bottom, right);
    const auto error_label = [&](double y, double error) {
        result += markup("<text class=\"axis\" x=\"{:.0f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", left - 8,
                         spot_of({0, y}).y + 4, error == 0 ? "none" : fmt::format("{:.2g}", error));
    };
    const auto by_error = std::ranges::minmax(points, {}, &CurvePoint::error);
    error_label(places[static_cast<std::size_t>(std::ranges::find(points, by_error.max.error, &CurvePoint::error) -
                                                points.begin())]
                    .y,
                by_error.max.error);
    if (by_error.min.error < by_error.max.error)
        error_label(places[static_cast<std::size_t>(std::ranges::find(points, by_error.min.error, &CurvePoint::error) -
                                                    points.begin())]
                        .y,
                    by_error.min.error);
    const auto by_time = std::ranges::minmax(points, {}, &CurvePoint::seconds);
    result += markup("<text class=\"axis\" x=\"{:.0f}\" y=\"{:.0f}\">{}</text>", left + inset - 12, bottom + 18,
                     curve_time_text(by_time.min.seconds));
    result += markup("<text class=\"axis\" x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"end\">{}</text>", right, bottom + 18,
                     curve_time_text(by_time.max.seconds));
    result += markup("<text class=\"axis\" x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">time of {} →</text>",
                     (left + right) / 2, bottom + 36, in_short(curve.case_name));
    result += markup(
        "<text class=\"axis\" transform=\"translate(14 {:.0f}) rotate(-90)\" text-anchor=\"middle\">error{}{} "
        "→</text>",
        (top + bottom) / 2, curve.unit.empty() ? "" : ", ", curve.unit);
    return result;
}

Markup drawing(const UnitCurve& curve)
{
    std::vector<CurvePoint> points = curve.others;
    points.push_back(curve.yours);
    const std::vector<CurvePlace> places = curve_places(curve);
    Markup result = markup(
        "<svg viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\" aria-label=\"Error "
        "over time: "
        "the table beside has the figures\">",
        width, height);
    result += axes(curve, points, places);
    std::string line;
    for (const std::size_t i : curve_front(curve)) {
        const Spot spot = spot_of(places[i]);
        line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", spot.x, spot.y);
    }
    result += markup("<path class=\"front\" d=\"{}\"/>", line);
    std::vector<Box> taken;
    for (const CurvePlace& place : places) {
        const Spot spot = spot_of(place);
        taken.push_back({spot.x - 7, spot.y - 7, spot.x + 7, spot.y + 7});
    }
    // The student's name has the first choice.
    const Spot yours = spot_of(places.back());
    const Spot word = place_of_name(yours, 5, taken);
    result += leader(yours, word);
    Markup names = markup("<text class=\"of-yours\" x=\"{:.1f}\" y=\"{:.1f}\">yours</text>", word.x, word.y);
    for (std::size_t i = 0; i < curve.others.size(); ++i) {
        const Spot spot = spot_of(places[i]);
        const bool reference = curve.others[i].name == "reference";
        result += markup("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"/>",
                         reference ? "of-reference" : "other", spot.x, spot.y);
        const std::string name = in_short(curve.others[i].name);
        const Spot beside = place_of_name(spot, letters_of(name), taken);
        result += leader(spot, beside);
        names += markup("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", reference ? "of-reference" : "other",
                        beside.x, beside.y, name);
    }
    result += markup("<path class=\"of-yours\" d=\"M{:.1f} {:.1f}l8 8-8 8-8-8z\"/>", yours.x, yours.y - 8);
    result += names;
    result += "</svg>";
    return result;
}

Markup figures(const UnitCurve& curve)
{
    Markup rows;
    const auto add = [&](const char* kind, std::string_view name, const CurvePoint& point) {
        rows += markup(
            "<tr class=\"{}\"><th scope=\"row\">{}</th><td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n",
            kind, name, curve_error_text(curve, point.error), curve_time_text(point.seconds));
    };
    add("of-yours", "yours", curve.yours);
    for (const CurvePoint& one : curve.others) add(one.name == "reference" ? "of-reference" : "other", one.name, one);
    return markup(
        "<table><thead><tr><th scope=\"col\">Solution</th><th scope=\"col\" class=\"number\">Error</th><th "
        "scope=\"col\" "
        "class=\"number\">Time</th></tr></thead>\n<tbody>\n{}</tbody></table>",
        rows);
}

}

Markup curve_section(const UnitCurve& curve)
{
    return markup(
        "<div class=\"curve\"><h3>What your accuracy costs</h3>\n<p class=\"place\">{}</p>\n<div "
        "class=\"plot\">{}{}</div>\n<p "
        "class=\"note\">Error: of 95 in 100 rows of {}. Time: of the processor, for the whole case {}. <code>umbral "
        "bench "
        "accuracy {}</code> measures the same choice closely. It gives no points.</p></div>\n",
        curve_sentence(curve), drawing(curve), figures(curve), curve.check, curve.case_name, curve.knob);
}

}
