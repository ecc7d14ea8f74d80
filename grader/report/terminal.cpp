#include "report/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/curve_plot.hpp"
#include "report/details.hpp"
#include "report/hidden.hpp"
#include "report/layout.hpp"
#include "report/paint.hpp"
#include "report/reruns.hpp"

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
        if (check.error && std::isfinite(*check.error) && (worst == nullptr || *check.error > *worst->error))
            worst = &check;
    if (worst == nullptr) return "";
    if (!worst->reference_error) return fmt::format("{:.3g}", *worst->error);
    return fmt::format("{:.3g} / {:.3g}", *worst->error, *worst->reference_error);
}

/// The student's time and the reference's.
std::string times(const UnitResult& unit)
{
    const std::string reference = duration(unit.reference_seconds);
    const std::string yours = duration(unit.seconds);
    return yours.empty() || reference.empty() ? yours : fmt::format("{} / {}", yours, reference);
}

struct Line {
    Verdict verdict;
    std::string id, points, words, error, time;
    Millipoints score, max_score;
};

Line line_of(const UnitResult& unit, const Paint& paint)
{
    const Verdict verdict = shown_verdict(unit);
    const std::string points = fmt::format("{}/{}", points_text(unit.score), points_text(unit.max_score));
    return {verdict,           paint.safe(unit.id), points,     std::string(in_words(verdict)),
            worst_error(unit), times(unit),         unit.score, unit.max_score};
}

/// Widths of the overview's columns; a column of width 0 is left out.
struct Columns {
    int id, points, words, error, time;

    [[nodiscard]] int total() const
    {
        const int fixed = margin + 2 + id + 2 + bar_cells + 2 + points + 2 + words;
        return fixed + (error > 0 ? error + 2 : 0) + (time > 0 ? time + 2 : 0);
    }
};

/// Columns as wide as their widest text, the heading's too; a column in which only the heading says something is left
/// out.
Columns columns_for(const std::vector<Line>& lines, const Line& heading, int width)
{
    const auto widest = [&](std::string Line::*text) {
        int cells = 0;
        for (const Line& line : lines) cells = std::max(cells, display_width(line.*text));
        return cells == 0 ? 0 : std::max(cells, display_width(heading.*text));
    };
    Columns columns{widest(&Line::id), widest(&Line::points), widest(&Line::words), widest(&Line::error),
                    widest(&Line::time)};
    const auto shrink = [&](int& column, int least) {
        column = std::max(std::min(column, least), column - std::max(0, columns.total() - width));
    };
    shrink(columns.id, 16);
    shrink(columns.words, 20);
    for (int* column : {&columns.time, &columns.error})
        if (columns.total() > width) *column = 0;
    shrink(columns.words, 8);
    shrink(columns.id, 8);
    return columns;
}

std::string row(const Columns& columns, const Line& line, std::string_view mark, std::string_view bar, Tone id_tone,
                Tone words_tone, const Paint& paint)
{
    const auto cell = [&](std::string_view text, int width, Tone tone) {
        return paint(tone, pad(shorten(text, width, paint.ellipsis()), width));
    };
    const auto number = [&](std::string_view text, int width, Tone tone) {
        return width == 0 ? std::string() : fmt::format("  {}", paint(tone, pad(text, width, Align::right)));
    };
    std::string text = fmt::format("{:{}}{} {}  {}  {}  {}", "", margin, mark, cell(line.id, columns.id, id_tone), bar,
                                   paint(Tone::plain, pad(line.points, columns.points, Align::right)),
                                   cell(line.words, columns.words, words_tone));
    text += number(line.error, columns.error, Tone::quiet) + number(line.time, columns.time, Tone::quiet);
    return text + "\n";
}

/// In units that were judged: where nothing ran, all fail.
int failing_hidden(const SubmissionResult& submission)
{
    int count = 0;
    for (const UnitResult& unit : submission.units) {
        if (unit.verdict != Verdict::partial && unit.verdict != Verdict::wrong) continue;
        count += static_cast<int>(
            std::ranges::count_if(unit.checks, [](const CheckResult& check) { return check.hidden && fails(check); }));
    }
    return count;
}

/// Where the student's choices lie on the curves of the units' knobs: drawn for one unit, one sentence each for
/// several.
std::string curves(const SubmissionResult& submission, int width, const Paint& paint)
{
    std::string text;
    for (const UnitResult& unit : submission.units) {
        if (!unit.curve) continue;
        const UnitCurve& curve = *unit.curve;
        std::vector<std::string> lines =
            wrap(fmt::format("{}: {}", paint.safe(submission.units.size() == 1 ? "accuracy" : unit.id),
                             shown_sentence(curve, paint)),
                 width);
        if (submission.units.size() == 1) {
            lines.emplace_back();
            for (std::string& line : curve_plot(curve, width, paint)) lines.push_back(std::move(line));
            lines.emplace_back();
            // A command stands whole in a line of its own.
            for (const std::string& said :
                 {fmt::format("Error of {} over time of {}; it gives no points. More:", curve.check, curve.case_name),
                  "umbral bench accuracy " + curve.knob})
                for (const std::string& line : wrap(paint.safe(said), width)) lines.push_back(paint(Tone::quiet, line));
        }
        if (text.empty() || submission.units.size() == 1) text += '\n';
        for (const std::string& line : lines)
            text += line.empty() ? "\n" : fmt::format("{}{}\n", std::string(margin, ' '), line);
    }
    return text;
}

std::string summary(const SubmissionResult& submission, const Paint& paint)
{
    const auto open = std::ranges::count_if(submission.units, [](const UnitResult& unit) { return !all_right(unit); });
    if (submission.units.empty()) return paint(Tone::fault, "No unit was checked.");
    if (open == 0) return paint(Tone::good, "Everything is right.");
    std::string text = fmt::format("{} of {} {} not right yet", open, submission.units.size(),
                                   submission.units.size() == 1 ? "unit is" : "units are");
    if (open == 1 && submission.units.size() > 1)
        text = fmt::format("1 of {} units is not right yet", submission.units.size());
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
    const Line heading{Verdict::ok, "unit", "points", "verdict", "error / ref.", "time / ref.", 0, 0};
    const std::string sum = fmt::format("{}/{}", points_text(shown.score), points_text(shown.max_score));
    const Line total{Verdict::ok, "total", sum, " ", "", "", shown.score, shown.max_score};
    std::vector<Line> lines{total};
    for (const UnitResult& unit : shown.units) lines.push_back(line_of(unit, paint));
    const Columns columns = columns_for(lines, heading, width);
    lines.erase(lines.begin());

    const std::string indent(margin, ' ');
    std::string text = "\n";
    // One's own work has no name.
    if (!shown.id.empty()) {
        const std::string name = shorten(paint.safe(shown.id), width - 2 * margin, paint.ellipsis());
        text += fmt::format("{}{}\n\n", indent, paint(Tone::strong, name));
    }
    text += row(columns, heading, " ", std::string(bar_cells, ' '), Tone::quiet, Tone::quiet, paint);
    for (const Line& line : lines)
        text += row(columns, line, paint.mark(line.verdict),
                    paint.bar(line.score, line.max_score, bar_cells, tone_of(line.verdict)), Tone::plain,
                    tone_of(line.verdict), paint);
    text += fmt::format("{}{}\n", indent, paint.rule(width - 2 * margin));
    text += row(columns, total, " ", paint.bar(total.score, total.max_score, bar_cells, Tone::plain), Tone::strong,
                Tone::plain, paint);
    for (const UnitResult& unit : shown.units)
        if (!all_right(unit)) text += unit_details(unit, width, paint, style.folder);
    text += curves(shown, width - 2 * margin, paint);
    for (const UnitResult& unit : shown.units)
        for (const std::string& sentence : seeds_of_noise(unit))
            for (const std::string& line : wrap(paint.safe(unit.id + ": " + sentence), width - 2 * margin))
                text += fmt::format("{}{}\n", indent, paint(Tone::quiet, line));
    return text + fmt::format("\n{}{}\n", indent, summary(shown, paint));
}

}
