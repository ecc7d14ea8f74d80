#include "report/curve_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/curve_places.hpp"
#include "report/curve_words.hpp"
#include "report/layout.hpp"

namespace umbral::grader {
namespace {

constexpr int rows = 8;
constexpr int most_columns = 48;
constexpr int axis_width = 14;  ///< errors, left of the axis

struct PlotCell {
    char letter = ' ';  ///< ' ': nothing
    bool yours = false;
};

/// Cells row by row from above. Where one is taken, a letter goes on to the right, or back to the left.
class Canvas {
public:
    explicit Canvas(int columns) : columns_(columns), cells_(static_cast<std::size_t>(rows * columns)) {}

    void put(const CurvePlace& place, char letter, bool yours)
    {
        const int y = static_cast<int>(std::lround((1 - place.y) * (rows - 1)));
        const int x = static_cast<int>(std::lround(place.x * (columns_ - 1)));
        for (int step = 0; step < 2 * columns_; ++step) {
            const int tried = x + (step % 2 == 0 ? step / 2 : -(step + 1) / 2);
            if (tried < 0 || tried >= columns_ || at(tried, y).letter != ' ') continue;
            at(tried, y) = {letter, yours};
            return;
        }
    }
    [[nodiscard]] std::string line(int y, const Paint& paint) const
    {
        std::string text;
        for (int x = 0; x < columns_; ++x) {
            const PlotCell& cell = cells_[static_cast<std::size_t>(y * columns_ + x)];
            if (cell.yours)
                text += paint(Tone::yours, paint.symbol("◆", "*"));
            else
                text += cell.letter;
        }
        return text;
    }

private:
    PlotCell& at(int x, int y) { return cells_[static_cast<std::size_t>(y * columns_ + x)]; }

    int columns_;
    std::vector<PlotCell> cells_;
};

char letter_of(std::size_t index) { return static_cast<char>(index < 26 ? 'a' + index : '+'); }

}

std::string shown_sentence(const UnitCurve& curve, const Paint& paint)
{
    std::string text = paint.safe(curve_sentence(curve));
    if (!paint.symbol("", "x").empty())
        for (const std::string_view quote : {"“", "”"})
            for (std::size_t at = text.find(quote); at != std::string::npos; at = text.find(quote))
                text.replace(at, quote.size(), "\"");
    return text;
}

std::vector<std::string> curve_plot(const UnitCurve& curve, int width, const Paint& paint)
{
    const int columns = std::clamp(width - axis_width - 3, 8, most_columns);
    const std::vector<CurvePlace> places = curve_places(curve);
    Canvas canvas(columns);
    // The student's own point keeps its place.
    canvas.put(places.back(), '*', true);
    for (std::size_t i = 0; i < curve.others.size(); ++i) canvas.put(places[i], letter_of(i), false);

    std::vector<CurvePoint> points = curve.others;
    points.push_back(curve.yours);
    std::vector<std::string> labels(rows);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (places[i].y == 0 || places[i].y == 1 || i + 1 == points.size())
            labels[static_cast<std::size_t>(std::lround((1 - places[i].y) * (rows - 1)))] =
                curve_error_text(curve, points[i].error);
    std::vector<std::string> lines;
    for (int y = 0; y < rows; ++y) {
        const std::string& label = labels[static_cast<std::size_t>(y)];
        lines.push_back(paint(Tone::quiet, pad(label, axis_width, Align::right) + ' ' +
                                               std::string(paint.symbol(label.empty() ? "│" : "┤", "|"))) +
                        canvas.line(y, paint));
    }
    std::string rule;
    for (int x = 0; x < columns; ++x) rule += paint.symbol("─", "-");
    const auto [quickest, slowest] = std::ranges::minmax(points, {}, &CurvePoint::seconds);
    const std::string left = curve_time_text(quickest.seconds);
    lines.push_back(paint(Tone::quiet, std::string(axis_width + 1, ' ') + std::string(paint.symbol("└", "+")) + rule));
    lines.push_back(
        paint(Tone::quiet, std::string(axis_width + 2, ' ') + left +
                               pad(curve_time_text(slowest.seconds), columns - display_width(left), Align::right)));
    const auto meaning = [&](const std::string& mark, std::string_view name, const CurvePoint& point) {
        const int room = std::max(8, width - 2 - 16 - 10);
        lines.push_back(fmt::format(
            "{} {}{}{}", mark, pad(shorten(paint.safe(name), std::min(room, 28), paint.ellipsis()), std::min(room, 28)),
            pad(curve_error_text(curve, point.error), 16, Align::right),
            pad(curve_time_text(point.seconds), 10, Align::right)));
    };
    meaning(paint(Tone::yours, paint.symbol("◆", "*")), "yours", curve.yours);
    for (std::size_t i = 0; i < curve.others.size(); ++i)
        meaning(std::string(1, letter_of(i)), curve.others[i].name, curve.others[i]);
    return lines;
}

}
