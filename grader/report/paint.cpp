#include "report/paint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "text/escape.hpp"

namespace umbral::grader {
namespace {

// Only the sixteen colours that every terminal theme defines, so that the report is readable on dark and on light
// ground.
std::string_view sequence(Tone tone)
{
    switch (tone) {
        case Tone::plain: return "";
        case Tone::strong: return "\x1b[1m";
        case Tone::quiet: return "\x1b[2m";
        case Tone::good: return "\x1b[32m";
        case Tone::part: return "\x1b[33m";
        case Tone::bad: return "\x1b[31m";
        case Tone::fault: return "\x1b[35m";
        case Tone::yours: return "\x1b[1;31m";
        case Tone::expected: return "\x1b[1;36m";
    }
    return "";
}

}

std::string Paint::operator()(Tone tone, std::string_view text) const
{
    if (!style_.color || tone == Tone::plain || text.empty()) return std::string(text);
    return fmt::format("{}{}\x1b[0m", sequence(tone), text);
}

std::string Paint::safe(std::string_view text) const
{
    return escape_terminal(text, {.lines = false, .unicode = style_.unicode});
}
std::string Paint::safe_lines(std::string_view text) const
{
    return escape_terminal(text, {.lines = true, .unicode = style_.unicode});
}

std::string_view Paint::plain_mark(Verdict verdict) const
{
    switch (verdict) {
        case Verdict::ok: return symbol("✓", "+");
        case Verdict::partial: return symbol("◐", "~");
        case Verdict::wrong: return symbol("✗", "x");
        case Verdict::not_implemented:
        case Verdict::missing: return symbol("○", "o");
        case Verdict::grader_fault: return "?";
        default: return "!";
    }
}

std::string Paint::mark(Verdict verdict) const { return (*this)(tone_of(verdict), plain_mark(verdict)); }

std::string Paint::rule(int width) const
{
    std::string line;
    for (int i = 0; i < width; ++i) line += symbol("─", "-");
    return (*this)(Tone::quiet, line);
}

std::string Paint::bar(Millipoints score, Millipoints max_score, int cells, Tone tone) const
{
    const auto share = [&] { return static_cast<double>(score) / static_cast<double>(max_score); };
    int filled = max_score <= 0 || score <= 0 ? 0
                 : score >= max_score         ? cells
                                              : static_cast<int>(share() * cells + 0.5);
    if (score > 0 && score < max_score) filled = std::clamp(filled, 1, cells - 1);
    std::string full;
    std::string empty;
    for (int i = 0; i < cells; ++i) i < filled ? full += symbol("█", "#") : empty += symbol("░", ".");
    return (*this)(tone, full) + (*this)(Tone::quiet, empty);
}

Tone tone_of(Verdict verdict)
{
    switch (verdict) {
        case Verdict::ok: return Tone::good;
        case Verdict::partial: return Tone::part;
        case Verdict::not_implemented:
        case Verdict::missing: return Tone::quiet;
        case Verdict::grader_fault: return Tone::fault;
        default: return Tone::bad;
    }
}

std::string points_text(Millipoints points)
{
    const Millipoints part = std::abs(points % 1000);
    std::string text = fmt::format("{}{}", points < 0 && points > -1000 ? "-" : "", points / 1000);
    if (part == 0) return text;
    text += fmt::format(".{:03}", part);
    return text.substr(0, text.find_last_not_of('0') + 1);
}

}
