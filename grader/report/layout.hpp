#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// Cells that `text` takes on a terminal; colour sequences (ESC [ … m) take none. One line.
[[nodiscard]] int display_width(std::string_view text);

enum class Align { left, right };

/// `text` with spaces added up to `width` cells; wider text stays as it is.
[[nodiscard]] std::string pad(std::string_view text, int width, Align align = Align::left);

/// At most `width` cells of `text` (without colour), with `ellipsis` in place of what was cut from its end.
[[nodiscard]] std::string shorten(std::string_view text, int width, std::string_view ellipsis);

/// `text` (without colour) broken at spaces, and within words that are too long, into lines of at most `width` cells.
/// Line breaks in the text stay; an empty text is no line.
[[nodiscard]] std::vector<std::string> wrap(std::string_view text, int width);

/// `items` beside each other, three spaces apart, in lines of at most `width` cells; no item is broken unless it is
/// wider than a line.
[[nodiscard]] std::vector<std::string> flow(const std::vector<std::string>& items, int width);

/// The lines of `text`; a final line break ends the last line and begins none.
[[nodiscard]] std::vector<std::string_view> lines_of(std::string_view text);

}
