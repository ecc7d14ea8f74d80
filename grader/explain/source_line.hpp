#pragma once

#include <optional>
#include <string_view>

namespace umbral::grader {

/// Line `number` of a file, counted from 1, without its end; nothing if there is none.
[[nodiscard]] std::optional<std::string_view> source_line(std::string_view text, int number);

/// May the line be shown as one that runs? Not one of braces, parentheses and `else`, where code for what ends there
/// stands, nor the head of a class, where that of functions stands which nobody wrote.
[[nodiscard]] bool says_what_runs(std::string_view line);

/// Does it decide something within itself, by && or || or ?: Then a place in it need not be the whole line's.
[[nodiscard]] bool decides_within(std::string_view line);

}
