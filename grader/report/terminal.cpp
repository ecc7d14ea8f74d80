#include "report/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/details.hpp"
#include "report/hidden.hpp"
#include "report/layout.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

constexpr int least_width = 60;
constexpr int bar_cells = 10;
constexpr int margin = 2;

std::string duration(double seconds)
{
    if (!std::isfinite(seconds) || seconds <= 0) return "";
    if (seconds < 0.01) return fmt::format("{:.1f} ms", 1000 * seconds);
    return seconds < 1 ? fmt::format("{:.0f} ms", 1000 * seconds) : fmt::format("{:.1f} s", seconds);
}

/// The worst error among the checks that may be shown, in the unit of that check's tolerance.
std::string worst_error(const UnitResult& unit)
{
    const CheckResult* worst = nullptr;
    for (const CheckResult& check : unit.checks)
        if (check.error && std::isfinite(*check.error) && (worst == nullptr || *check.error > *worst->error)) worst = &check;
    if (worst == nullptr) return "";
    if (!worst->reference_error) return fmt::format("{:.3g}", *worst->error);
    return fmt::format("{:.3g} / {:.3g}", *worst->error, *worst->reference_error);
}

struct Line {
    Verdict verdict;
    std::string id, points, words, error, time, ratio;
    Millipoints score, max_score;
};

Line line_of(const UnitResult& unit, const Paint& paint)
{
    const Verdict verdict = shown_verdict(unit);
    const bool timed = unit.seconds > 0 && unit.reference_seconds > 0 && std::isfinite(unit.seconds / unit.reference_seconds);
    return {verdict,
            paint.safe(unit.id),
            points_text(unit.score) + "/" + points_text(unit.max_score),
            std::string(in_words(verdict)),
            worst_error(unit),
            duration(unit.seconds),
            timed ? fmt::format("{:.1f}{}", unit.seconds / unit.reference_seconds, paint.symbol("×", "x")) : "",
            unit.score,
            unit.max_score};
}

/// Widths of the overview's columns; a column of width 0 is left out.
struct Columns {
    int id = 4, points = 6, words = 7, error = 0, time = 0, ratio = 0;
};

Columns columns_for(const std::vector<Line>& lines, int width)
{
    const auto widest = [&](std::string Line::*text, int least) {
        int cells = 0;
        for (const Line& line : lines) cells = std::max(cells, display_width(line.*text));
        return cells == 0 ? 0 : std::max(cells, least);
    };
    Columns columns{std::max(4, widest(&Line::id, 4)),
                    std::max(6, widest(&Line::points, 6)),
                    std::max(7, widest(&Line::words, 7)),
                    widest(&Line::error, 5),
                    widest(&Line::time, 4),
                    widest(&Line::ratio, 9)};
    const auto total = [&] {
        int cells = margin + 2 + columns.id + 2 + bar_cells + 2 + columns.points + 2 + columns.words;
        for (const int column : {columns.error, columns.time, columns.ratio}) cells += column > 0 ? column + 2 : 0;
        return cells;
    };
    constexpr int least_id = 16;
    const auto shrink_id = [&] { columns.id = std::max(std::min(columns.id, least_id), columns.id - std::max(0, total() - width)); };
    shrink_id();
    for (int* column : {&columns.ratio, &columns.time, &columns.error})
        if (total() > width) *column = 0;
    columns.words = std::max(7, columns.words - std::max(0, total() - width));
    return columns;
}

std::string row(const Columns& columns, const Line& line, std::string_view mark, std::string_view bar, Tone id_tone, Tone words_tone, const Paint& paint)
{
    const auto cell = [&](std::string_view text, int width, Tone tone) { return paint(tone, pad(shorten(text, width, paint.ellipsis()), width)); };
    const auto number = [&](std::string_view text, int width, Tone tone) {
        return width == 0 ? std::string() : fmt::format("  {}", paint(tone, pad(text, width, Align::right)));
    };
    std::string text = fmt::format("{:{}}{} {}  {}  {}  {}", "", margin, mark, cell(line.id, columns.id, id_tone), bar,
                                   paint(Tone::plain, pad(line.points, columns.points, Align::right)), cell(line.words, columns.words, words_tone));
    text += number(line.error, columns.error, Tone::quiet) + number(line.time, columns.time, Tone::quiet) + number(line.ratio, columns.ratio, Tone::quiet);
    return text + "\n";
}

int failing_hidden(const SubmissionResult& submission)
{
    int count = 0;
    for (const UnitResult& unit : submission.units)
        count += static_cast<int>(std::ranges::count_if(unit.checks, [](const CheckResult& check) { return check.hidden && check.score < check.max_score; }));
    return count;
}

std::string summary(const SubmissionResult& submission, const Paint& paint)
{
    const auto open = std::ranges::count_if(submission.units, [](const UnitResult& unit) { return !all_right(unit); });
    if (submission.units.empty()) return paint(Tone::fault, "No unit was checked.");
    if (open == 0) return paint(Tone::good, "Everything is right.");
    std::string text = fmt::format("{} of {} {} not right yet", open, submission.units.size(), submission.units.size() == 1 ? "unit is" : "units are");
    if (open == 1 && submission.units.size() > 1) text = fmt::format("1 of {} units is not right yet", submission.units.size());
    const int hidden = failing_hidden(submission);
    if (hidden > 0) text += fmt::format("; {} hidden {}", hidden, hidden == 1 ? "check fails" : "checks fail");
    return text + ".";
}

}

std::string terminal_report(const SubmissionResult& submission, const TerminalStyle& style)
{
    const Paint paint(style);
    const int width = std::max(style.width, least_width);
    const SubmissionResult shown = without_hidden_values(submission);
    std::vector<Line> lines;
    bool against_oracle = false;
    for (const UnitResult& unit : shown.units) {
        lines.push_back(line_of(unit, paint));
        against_oracle = against_oracle || lines.back().error.find('/') != std::string::npos;
    }
    Line total{Verdict::ok, "total", points_text(shown.score) + "/" + points_text(shown.max_score), "", "", "", "", shown.score, shown.max_score};
    lines.push_back(total);
    const Columns columns = columns_for(lines, width);
    lines.pop_back();

    const Line heading{Verdict::ok, "unit", "points", "verdict", against_oracle ? "error / reference" : "error", "time", "reference", 0, 0};
    Columns fitted = columns;
    if (columns.error > 0) fitted.error = std::max(columns.error, display_width(heading.error));
    const std::string indent(margin, ' ');
    std::string text = fmt::format("\n{}{}\n\n", indent, paint(Tone::strong, shorten(paint.safe(shown.id), width - 2 * margin, paint.ellipsis())));
    text += row(fitted, heading, " ", std::string(bar_cells, ' '), Tone::quiet, Tone::quiet, paint);
    for (const Line& line : lines)
        text += row(fitted, line, paint.mark(line.verdict), paint.bar(line.score, line.max_score, bar_cells, tone_of(line.verdict)), Tone::plain,
                    tone_of(line.verdict), paint);
    text += fmt::format("{}{}\n", indent, paint.rule(width - 2 * margin));
    text += row(fitted, total, " ", paint.bar(total.score, total.max_score, bar_cells, Tone::plain), Tone::strong, Tone::plain, paint);
    for (const UnitResult& unit : shown.units)
        if (!all_right(unit)) text += unit_details(unit, width, paint);
    return text + fmt::format("\n{}{}\n", indent, summary(shown, paint));
}

}
