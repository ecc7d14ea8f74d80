#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <vector>

#include "model/faults.hpp"
#include "report/clusters.hpp"
#include "report/hidden.hpp"
#include "report/layout.hpp"
#include "report/paint.hpp"
#include "report/reasons.hpp"
#include "report/terminal.hpp"

namespace umbral::grader {
namespace {

constexpr int least_table_width = 60;
constexpr int name_least = 8;
constexpr int name_most = 24;
constexpr int heading_least = 6;  // shorter beginnings of units' names say nothing
constexpr int heading_most = 16;
constexpr std::size_t most_reasons = 8;

struct UnitCell {
    std::string text;  ///< the points
    Verdict verdict = Verdict::missing;
    bool graded = false;
};

struct Column {
    std::string id;
    std::string heading;
    std::vector<UnitCell> cells;  ///< one a submission
    Millipoints sum = 0;
    Millipoints count = 0;
};

/// The units of all submissions, in the order in which they first appear.
std::vector<Column> columns_of(const ClassResult& result)
{
    std::vector<Column> columns;
    std::map<std::string, std::size_t> index;
    for (std::size_t s = 0; s < result.submissions.size(); ++s)
        for (const UnitResult& unit : result.submissions[s].units) {
            const auto [found, added] = index.emplace(unit.id, columns.size());
            if (added) columns.push_back({unit.id, "", std::vector<UnitCell>(result.submissions.size()), 0, 0});
            Column& column = columns[found->second];
            column.cells[s] = {points_text(unit.score), shown_verdict(unit), true};
            // A fault of the grader's says nothing about the student: it is no zero in the mean.
            if (unit.verdict == Verdict::grader_fault) continue;
            column.sum += unit.score;
            ++column.count;
        }
    return columns;
}

std::string mean_text(Millipoints sum, Millipoints count)
{
    // To hundredths of a point.
    return count == 0 ? "-" : points_text((sum + 5 * count) / (10 * count) * 10);
}

std::string short_name(const std::string& id)
{
    return id.substr(id.rfind('/') == std::string::npos ? 0 : id.rfind('/') + 1);
}

int widest_cell(const std::vector<Column>& columns)
{
    int width = 3;
    for (const Column& column : columns) {
        width = std::max(width, display_width(mean_text(column.sum, column.count)) + 2);
        for (const UnitCell& cell : column.cells) width = std::max(width, display_width(cell.text) + 2);
    }
    return width;
}

std::string cell_text(const UnitCell& cell, int width, const Paint& paint)
{
    if (!cell.graded) return paint(Tone::quiet, pad(fmt::format("{}  ", paint.symbol("·", ".")), width, Align::right));
    return pad(paint(tone_of(cell.verdict), fmt::format("{} {}", cell.text, paint.plain_mark(cell.verdict))), width,
               Align::right);
}

struct Frame {
    int name = name_least;
    int total = 5;
    int cell = 3;
};

std::string line_of(const Frame& frame, std::string_view name, std::string_view total,
                    const std::vector<std::string>& cells)
{
    std::string line = fmt::format("  {}  {} ", pad(name, frame.name), pad(total, frame.total, Align::right));
    for (const std::string& cell : cells) line += fmt::format(" {}", pad(cell, frame.cell, Align::right));
    return line + "\n";
}

std::string band(const ClassResult& result, const std::vector<std::string>& totals, std::span<const Column> columns,
                 const Frame& frame, const Paint& paint)
{
    const auto collect = [&](auto text) {
        std::vector<std::string> cells;
        for (const Column& column : columns) cells.push_back(text(column));
        return cells;
    };
    const std::string heading =
        line_of(frame, "submission", "total",
                collect([&](const Column& column) { return shorten(column.heading, frame.cell, paint.ellipsis()); }));
    const int width = display_width(heading.substr(0, heading.size() - 1));
    std::string text = paint(Tone::strong, heading.substr(0, heading.size() - 1)) + "\n";
    const std::string rule = fmt::format("  {}\n", paint.rule(width - 2));
    text += rule;
    for (std::size_t s = 0; s < result.submissions.size(); ++s)
        text += line_of(frame, shorten(paint.safe(result.submissions[s].id), frame.name, paint.ellipsis()), totals[s],
                        collect([&](const Column& column) { return cell_text(column.cells[s], frame.cell, paint); }));
    // A total that lacks units to a fault of the grader's says too little.
    Millipoints sum = 0;
    Millipoints whole = 0;
    for (const SubmissionResult& submission : result.submissions) {
        if (has_fault(submission)) continue;
        sum += submission.score;
        ++whole;
    }
    text += rule;
    text += line_of(frame, "mean", mean_text(sum, whole),
                    collect([&](const Column& column) { return mean_text(column.sum, column.count) + "  "; }));
    return text;
}

std::string legend(const std::vector<Column>& columns, bool numbered, int width, const Paint& paint)
{
    std::string text;
    if (numbered) {
        std::vector<std::string> names;
        for (const Column& column : columns)
            names.push_back(fmt::format("{} {}", column.heading, paint.safe(column.id)));
        for (const std::string& line : flow(names, width - 4)) text += fmt::format("  {}\n", line);
        text += "\n";
    }
    constexpr std::array shown = {Verdict::ok,      Verdict::partial,     Verdict::wrong, Verdict::not_implemented,
                                  Verdict::crashed, Verdict::grader_fault};
    constexpr std::array words = {"right",
                                  "partly right",
                                  "wrong",
                                  "not written",
                                  "did not build or run to its end",
                                  "fault of the grader, not scored"};
    std::vector<std::string> marks;
    for (std::size_t i = 0; i < shown.size(); ++i)
        marks.push_back(fmt::format("{} {}", paint.plain_mark(shown[i]), words[i]));
    for (const std::string& line : flow(marks, width - 4)) text += fmt::format("  {}\n", paint(Tone::quiet, line));
    return text;
}

/// What most fail for, a line each: "12 of 40  far root (very likely)  raytracing/sphere".
std::string reasons(const ClassResult& result, int width, const Paint& paint)
{
    struct Line {
        std::size_t size;
        std::string text;
    };
    std::vector<Line> lines;
    for (const UnitClusters& unit : clusters(result))
        for (const auto* kind : {&unit.explained, &unit.ambiguous})
            for (const Cluster& cluster : *kind)
                lines.push_back({cluster.who.size(),
                                 fmt::format("{} of {}  {} ({}{})  {}", cluster.who.size(), unit.graded,
                                             paint.safe(cluster.name), sure_words(cluster.confidence),
                                             kind == &unit.ambiguous ? " one of these" : "", paint.safe(unit.unit))});
    if (lines.empty()) return "";
    std::ranges::stable_sort(lines, std::ranges::greater{}, &Line::size);
    std::string text = "\n  Why, by the number of submissions\n";
    for (const Line& line : std::span(lines).first(std::min(lines.size(), most_reasons)))
        text += fmt::format("  {}\n", shorten(line.text, width - 2, paint.ellipsis()));
    if (lines.size() > most_reasons)
        text += fmt::format("  {} and {} more\n", paint.ellipsis(), lines.size() - most_reasons);
    return text;
}

}

std::string class_table(const ClassResult& result, const TerminalStyle& style)
{
    const Paint paint(style);
    const int width = std::max(style.width, least_table_width);
    std::vector<Column> columns = columns_of(result);
    if (result.submissions.empty()) return "\n  No submission was graded.\n";

    Frame frame;
    std::vector<std::string> totals;
    for (const SubmissionResult& submission : result.submissions) {
        totals.push_back(points_text(submission.score) + "/" + points_text(submission.max_score));
        frame.total = std::max(frame.total, display_width(totals.back()));
        frame.name = std::max(frame.name, display_width(paint.safe(submission.id)));
    }
    frame.name = std::clamp(frame.name, display_width("submission"), name_most);

    const int room = width - 2 - frame.name - 2 - frame.total - 1;
    const int per_unit = columns.empty() ? room : room / static_cast<int>(columns.size()) - 1;
    const int needed = widest_cell(columns);
    const bool numbered = per_unit < std::max(needed, heading_least);
    int longest = heading_least;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        columns[i].heading = numbered ? std::to_string(i + 1) : paint.safe(short_name(columns[i].id));
        longest = std::max(longest, display_width(columns[i].heading));
    }
    frame.cell = numbered ? needed : std::max(needed, std::min({longest, heading_most, per_unit}));

    const std::size_t in_band = static_cast<std::size_t>(std::max(1, room / (frame.cell + 1)));
    std::string text = "\n";
    std::size_t start = 0;
    do {
        if (start > 0) text += "\n";
        text += band(result, totals, std::span(columns).subspan(start, std::min(in_band, columns.size() - start)),
                     frame, paint);
        start += in_band;
    } while (start < columns.size());
    return text + "\n" + legend(columns, numbered, width, paint) + reasons(result, width, paint);
}

}
