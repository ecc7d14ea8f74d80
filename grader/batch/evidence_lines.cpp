#include <fmt/format.h>

#include <algorithm>

#include "batch/evidence_kinds.hpp"
#include "judge/alignment.hpp"
#include "judge/events.hpp"
#include "judge/gl_calls.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_lines = 4000;  // of a trace that are compared
constexpr std::size_t most_shown = 120;   // rows of the table
constexpr std::size_t context = 2;        // equal lines kept beside a difference

/// Lines of both sides with what belongs together.
struct Sides {
    std::vector<std::string> yours;
    std::vector<std::string> expected;
    Alignment alignment;
};

html::LinePair same_lines(const Sides& sides, std::size_t a, std::size_t b)
{
    return {html::LineKind::same, a + 1, b + 1, sides.yours[a], sides.expected[b], 0};
}

/// What lies between two matches: lines of both sides pair up in their order, the rest is missing or extra.
void add_gap(const Sides& sides, std::size_t a, std::size_t a_end, std::size_t b, std::size_t b_end, html::LinesEvidence& result)
{
    for (; a < a_end || b < b_end;) {
        const bool both = a < a_end && b < b_end;
        html::LinePair line;
        line.kind = both ? html::LineKind::changed : a < a_end ? html::LineKind::extra : html::LineKind::missing;
        ++(both ? result.changed : a < a_end ? result.extra : result.missing);
        if (a < a_end) line.yours = sides.yours[a], line.yours_number = ++a;
        if (b < b_end) line.expected = sides.expected[b], line.expected_number = ++b;
        result.lines.push_back(std::move(line));
    }
}

/// Long runs of equal lines shrink to their ends and a count.
std::vector<html::LinePair> folded(std::vector<html::LinePair> lines)
{
    std::vector<html::LinePair> result;
    for (std::size_t start = 0; start < lines.size();) {
        std::size_t end = start;
        while (end < lines.size() && lines[end].kind == html::LineKind::same) ++end;
        const std::size_t before = start == 0 ? 0 : context;
        const std::size_t after = end == lines.size() ? 0 : context;
        if (end - start > before + after + 1) {
            const auto from = lines.begin() + static_cast<std::ptrdiff_t>(start);
            std::move(from, from + static_cast<std::ptrdiff_t>(before), std::back_inserter(result));
            html::LinePair omitted;
            omitted.kind = html::LineKind::omitted;
            omitted.omitted = end - start - before - after;
            result.push_back(std::move(omitted));
            start = end - after;
        }
        while (start < end) result.push_back(std::move(lines[start++]));
        if (end < lines.size()) result.push_back(std::move(lines[end]));
        start = end + 1;
    }
    return result;
}

html::LinesEvidence lines_evidence(const Sides& sides, std::string what, bool cut)
{
    html::LinesEvidence result;
    result.what = std::move(what);
    std::size_t a = 0;
    std::size_t b = 0;
    for (const auto& [match_a, match_b] : sides.alignment.matches) {
        add_gap(sides, a, match_a, b, match_b, result);
        result.lines.push_back(same_lines(sides, match_a, match_b));
        a = match_a + 1;
        b = match_b + 1;
    }
    add_gap(sides, a, sides.yours.size(), b, sides.expected.size(), result);
    result.lines = folded(std::move(result.lines));
    result.cut = cut || result.lines.size() > most_shown;
    if (result.lines.size() > most_shown) result.lines.resize(most_shown);
    return result;
}

/// "glBufferData(GL_ARRAY_BUFFER, …), 128 bytes"
std::vector<std::string> call_lines(const GlTrace& trace, bool& cut)
{
    std::vector<std::string> lines;
    for (const GlCall& call : trace.calls) {
        if (lines.size() == most_lines) {
            cut = true;
            break;
        }
        lines.push_back(in_cpp(call) + (call.bytes > 0 ? fmt::format(", {} bytes", call.bytes) : ""));
    }
    return lines;
}

/// "zoom (2, 0.5)": the code's name, or the code, then the numbers.
std::vector<std::string> event_lines(const TensorView& view, const std::map<double, std::string>& names, bool& cut)
{
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < view.cells(); ++i) {
        if (lines.size() == most_lines) {
            cut = true;
            break;
        }
        const auto event = view.cell(i);
        const auto name = names.find(event[0]);
        std::string text = name != names.end() ? name->second : fmt::format("event {}", number_text(event[0]));
        for (std::size_t k = 1; k < event.size(); ++k) text += (k == 1 ? " (" : ", ") + number_text(event[k]);
        lines.push_back(event.size() > 1 ? text + ")" : text);
    }
    return lines;
}

}

html::Evidence trace_evidence(const Tensor& yours, const Tensor& expected)
{
    const std::optional<GlTrace> mine = parse_gl_trace(text_of(&yours));
    const std::optional<GlTrace> theirs = parse_gl_trace(text_of(&expected));
    if (!mine || !theirs) return {};
    bool cut = mine->truncated || theirs->truncated;
    Sides sides{call_lines(*mine, cut), call_lines(*theirs, cut), {}};
    // Object numbers are each program's own; how much is uploaded is not.
    sides.alignment = align(sides.yours.size(), sides.expected.size(), [&](std::size_t i, std::size_t j) {
        return same_call(mine->calls[i], theirs->calls[j]) && mine->calls[i].bytes == theirs->calls[j].bytes;
    });
    return lines_evidence(sides, "Calls", cut);
}

html::Evidence events_evidence(const Check& check, const Observation& observation)
{
    bool cut = false;
    const TensorView yours(*observation.yours);
    const TensorView expected(*observation.expected);
    const auto names = event_names(text_of(observation.names));
    Sides sides{event_lines(yours, names, cut), event_lines(expected, names, cut), {}};
    if (yours.cells() > 0 && yours.components() != expected.components()) return {};
    sides.alignment = align_events(check, yours, expected);
    std::erase_if(sides.alignment.matches, [&](const auto& match) { return match.first >= sides.yours.size() || match.second >= sides.expected.size(); });
    return lines_evidence(sides, "Events", cut);
}

}
