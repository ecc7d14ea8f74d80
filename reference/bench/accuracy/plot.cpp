#include "plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "axis.hpp"
#include "knee.hpp"
#include "labels.hpp"
#include "text/escape.hpp"

namespace umbral::bench {
namespace {

constexpr double left = 74;
constexpr double top = 18;
constexpr double zero_room = 34;   // the line of zeros, below the logarithmic part
constexpr double name_room = 128;  // for the names of series

bool is_drawn(const Mark& mark) { return mark.x > 0 && std::isfinite(mark.x) && mark.y >= 0 && std::isfinite(mark.y); }

/// Where values lie in the picture.
struct Frame {
    double width;
    double right;
    double bottom;
    LogAxis x;
    LogAxis y;
    bool names_at_start;
    bool has_zero;
    [[nodiscard]] double x_of(const Mark& mark) const { return x.at(mark.x); }
    [[nodiscard]] double y_of(const Mark& mark) const { return mark.y > 0 ? y.at(mark.y) : bottom - 12; }
};

/// Names stand at that end of the lines where these lie farther apart.
bool spread_at_start(const std::vector<Series>& series)
{
    const auto spread = [&](auto end) {
        double least = INFINITY;
        double most = 0;
        for (const Series& one : series) {
            if (one.marks.empty() || !(end(one).y > 0)) continue;
            least = std::min(least, end(one).y);
            most = std::max(most, end(one).y);
        }
        return most / least;
    };
    return spread([](const Series& one) { return one.marks.front(); }) >
           spread([](const Series& one) { return one.marks.back(); });
}

Frame frame_of(const Plot& plot, const std::vector<Series>& series)
{
    const double right = plot.width - 20;
    const double bottom = plot.height - 58;
    std::vector<double> xs;
    std::vector<double> ys;
    bool has_zero = false;
    bool has_names = false;
    for (const Series& one : series) {
        has_names = has_names || !one.name.empty();
        for (const Mark& mark : one.marks) {
            xs.push_back(mark.x);
            ys.push_back(mark.y);
            has_zero = has_zero || mark.y == 0;
        }
    }
    const bool at_start = has_names && spread_at_start(series);
    return {plot.width,
            right,
            bottom,
            LogAxis(xs, left, right, at_start ? name_room : 24, has_names && !at_start ? name_room : 40),
            LogAxis(ys, bottom - (has_zero ? zero_room : 0), top, 18, 22),
            at_start,
            has_zero};
}

/// Powers of ten as people write them where their zeros would have to be counted.
std::string tick_text(double value)
{
    const double exponent = std::log10(value);
    if (std::abs(exponent - std::round(exponent)) > 1e-9 || std::abs(exponent) < 3.5) return number_text(value);
    constexpr std::array digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::lround(std::abs(exponent))))
        text += digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

std::string axes(const Plot& plot, const Frame& frame)
{
    std::string text = "<g class=\"grid\">";
    std::string words;
    for (const LogAxis::Tick& tick : frame.x.ticks()) {
        const double x = frame.x.at(tick.value);
        text += fmt::format("<path class=\"{}\" d=\"M{:.1f} {}V{}\"/>", tick.labelled ? "major" : "minor", x, top,
                            frame.bottom);
        if (tick.labelled)
            words += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>", x, frame.bottom + 18,
                                 tick_text(tick.value));
    }
    for (const LogAxis::Tick& tick : frame.y.ticks()) {
        const double y = frame.y.at(tick.value);
        text += fmt::format("<path class=\"{}\" d=\"M{} {:.1f}H{}\"/>", tick.labelled ? "major" : "minor", left, y,
                            frame.right);
        if (tick.labelled)
            words += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", left - 8, y + 4,
                                 tick_text(tick.value));
    }
    if (frame.has_zero) {
        text += fmt::format("<path class=\"zero\" d=\"M{} {}H{}\"/>", left, frame.bottom - zero_room + 8, frame.right);
        words += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">0</text>", left - 8, frame.bottom - 8);
    }
    text += "</g><g class=\"axis\">" + words;
    text += fmt::format("<text class=\"name\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                        (left + frame.right) / 2, plot.height - 12, escape_html(plot.x_label));
    text += fmt::format(
        "<text class=\"name\" transform=\"translate(16 {}) rotate(-90)\" text-anchor=\"middle\">{}</text></g>",
        (top + frame.bottom) / 2, escape_html(plot.y_label));
    return text;
}

/// One shape a series, so that colour is never the only difference.
std::string shape(std::size_t series, double x, double y)
{
    constexpr std::array shapes = {"m-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0z",
                                   "m-4-4h8v8h-8z",
                                   "m0-5.4 5 8.7h-10z",
                                   "m0-5.8 5.8 5.8-5.8 5.8-5.8-5.8z",
                                   "m0 5.4 5-8.7h-10z",
                                   "m-5-1.7h3.3v-3.3h3.4v3.3h3.3v3.4h-3.3v3.3h-3.4v-3.3h-3.3z"};
    return fmt::format("M{:.1f} {:.1f}{}", x, y, shapes[series % shapes.size()]);
}

std::string line_of(const Series& series, const Frame& frame)
{
    std::string path;
    for (const Mark& mark : series.marks)
        if (series.joined && !mark.quiet)
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', frame.x_of(mark), frame.y_of(mark));
    return path.empty() ? "" : "<path class=\"line\" d=\"" + path + "\"/>";
}

/// Rings that were drawn: several knees in one place get one.
class Rings {
public:
    /// Was there one within a few pixels? If not, there is now.
    bool near(double x, double y)
    {
        for (const auto& [other_x, other_y] : drawn_)
            if (std::hypot(x - other_x, y - other_y) < 12) return true;
        drawn_.emplace_back(x, y);
        return false;
    }

private:
    std::vector<std::pair<double, double>> drawn_;
};

/// A target for pointer and keyboard, with the note that it shows.
std::string target(const Mark& mark, double x, double y, double width)
{
    std::vector<std::string> lines;
    std::istringstream stream(mark.tip);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    double note_width = 0;
    for (const std::string& line : lines) note_width = std::max(note_width, 16 + text_width(line));
    const double note_height = 12 + 17 * static_cast<double>(lines.size());
    const double note_x = std::clamp(x + 12, 4.0, width - note_width - 4);
    const double note_y = y - note_height - 12 > 2 ? y - note_height - 12 : y + 14;
    std::string text = fmt::format(
        "<g class=\"target\" tabindex=\"0\" role=\"img\" aria-label=\"{}\"><circle class=\"hit\" cx=\"{:.1f}\" "
        "cy=\"{:.1f}\" r=\"9\"/>"
        "<g class=\"tip\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"6\"/>",
        escape_html(mark.tip), x, y, note_x, note_y, note_width, note_height);
    for (std::size_t i = 0; i < lines.size(); ++i)
        text += fmt::format("<text{} x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", i == 0 ? " class=\"first\"" : "", note_x + 8,
                            note_y + 20 + 17 * static_cast<double>(i), escape_html(lines[i]));
    return text + "</g></g>";
}

/// Names beside the ends of the lines, labels beside marks, and the knee's label always.
std::string written(const std::vector<Series>& series, const Frame& frame)
{
    Labels labels({left, top, frame.right, frame.bottom});
    for (const Series& one : series)
        for (const Mark& mark : one.marks) labels.keep_free(frame.x_of(mark), frame.y_of(mark), mark.quiet ? 3 : 6);
    std::string text;
    const auto write = [&](const std::optional<Place>& place, const std::string& words, const char* kind) {
        if (place)
            text += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", kind, place->x, place->y,
                                escape_html(words));
    };
    std::vector<NamedEnd> ends;
    for (const Series& one : series) {
        if (one.name.empty() || one.marks.empty()) continue;
        const Mark& end = frame.names_at_start ? one.marks.front() : one.marks.back();
        ends.push_back({one.name, frame.x_of(end), frame.y_of(end)});
    }
    const std::vector<Place> places = labels.name_ends(ends, frame.names_at_start);
    for (std::size_t i = 0; i < ends.size(); ++i) write(places[i], ends[i].name, "series");
    // Knees first, then from the top of the picture downwards: who comes late may find no room.
    std::vector<const Mark*> wanted;
    for (const Series& one : series)
        for (const Mark& mark : one.marks)
            if (!mark.label.empty()) wanted.push_back(&mark);
    std::stable_sort(wanted.begin(), wanted.end(),
                     [](const Mark* a, const Mark* b) { return a->knee != b->knee ? a->knee : a->y > b->y; });
    for (const Mark* mark : wanted)
        write(labels.beside(frame.x_of(*mark), frame.y_of(*mark), mark->label, mark->knee), mark->label,
              mark->knee ? "label knee" : "label");
    return text;
}

}

std::string svg_of(const Plot& plot)
{
    std::vector<Series> series = plot.series;
    for (Series& one : series) std::erase_if(one.marks, [](const Mark& mark) { return !is_drawn(mark); });
    const Frame frame = frame_of(plot, series);
    std::string text = fmt::format(
        "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"group\" aria-labelledby=\"{}-title\"><title "
        "id=\"{}-title\">{}</title>",
        plot.width, plot.height, plot.id, plot.id, escape_html(plot.title));
    text += axes(plot, frame);
    std::string targets;
    Rings rings;
    for (std::size_t i = 0; i < series.size(); ++i) {
        text += fmt::format("<g class=\"s{}\">{}", i % 6, line_of(series[i], frame));
        for (const Mark& mark : series[i].marks) {
            const double x = frame.x_of(mark);
            const double y = frame.y_of(mark);
            if (mark.knee && !rings.near(x, y))
                text += fmt::format("<circle class=\"ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"10\"/>", x, y);
            text += fmt::format("<path class=\"mark{}\" d=\"{}\"/>", mark.quiet ? " quiet" : "", shape(i, x, y));
            targets += target(mark, x, y, plot.width);
        }
        text += "</g>";
    }
    // Targets come last: what lies later in the document lies on top, and a note must cover every mark.
    return text + "<g class=\"words\">" + written(series, frame) + "</g><g class=\"targets\">" + targets +
           "</g></svg>\n";
}

}
