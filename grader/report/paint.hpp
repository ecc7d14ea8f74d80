#pragma once

#include <string>
#include <string_view>

#include "report/terminal.hpp"

namespace umbral::grader {

/// What a piece of text is; how that looks is decided in one place.
enum class Tone { plain, strong, quiet, good, part, bad, fault, yours, expected };

/// Draws the elements that all terminal reports share, in one style. Takes text that is already escaped.
class Paint {
public:
    explicit Paint(const TerminalStyle& style) : style_(style) {}

    [[nodiscard]] std::string operator()(Tone tone, std::string_view text) const;
    /// Text from outside, one line.
    [[nodiscard]] std::string safe(std::string_view text) const;
    /// Text from outside whose line breaks stay.
    [[nodiscard]] std::string safe_lines(std::string_view text) const;

    [[nodiscard]] std::string_view symbol(std::string_view unicode, std::string_view ascii) const
    {
        return style_.unicode ? unicode : ascii;
    }
    [[nodiscard]] std::string_view ellipsis() const { return symbol("…", ".."); }
    [[nodiscard]] std::string mark(Verdict verdict) const;
    /// The same without colour, one cell wide.
    [[nodiscard]] std::string_view plain_mark(Verdict verdict) const;
    [[nodiscard]] std::string rule(int width) const;
    /// A bar of `cells` cells, filled as score / max_score; empty unless something was earned, full only if all was.
    [[nodiscard]] std::string bar(Millipoints score, Millipoints max_score, int cells, Tone tone) const;

private:
    TerminalStyle style_;
};

[[nodiscard]] Tone tone_of(Verdict verdict);

/// "7", "7.5", "0.125": at most three decimals, none that are zero.
[[nodiscard]] std::string points_text(Millipoints points);

}
