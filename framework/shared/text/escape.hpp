#pragma once

#include <string>
#include <string_view>

namespace umbral {

/// What may stay in a text that is escaped for a terminal.
struct TerminalText {
    bool lines =
        false;  ///< keep \n (and turn \r\n into it); otherwise a line break becomes visible like any control character
    bool unicode = true;  ///< the terminal shows UTF-8; otherwise the result is ASCII
};

/// Text from outside (students' names, output, diagnostics) made harmless and visible on a terminal.
///
/// No byte of the result can begin an escape sequence: control characters become their pictures (␛; `^[` in ASCII),
/// tabs become spaces up to the next multiple of four, C1 controls, bidirectional controls, invisible characters and
/// line separators become <U+202E>, and each byte that is not UTF-8 becomes <FF>. Everything else stays as it is.
[[nodiscard]] std::string escape_terminal(std::string_view text, TerminalText keep = {});

/// Text made fit for HTML, as content and within quoted attributes: & < > " ' are replaced, and what a terminal would
/// hide is made visible in the same way (control characters are not allowed in HTML). Line breaks stay.
[[nodiscard]] std::string escape_html(std::string_view text);

}
