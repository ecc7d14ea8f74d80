#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// Line `number` of a file, counted from 1, without its end; nothing if there is none.
[[nodiscard]] std::optional<std::string_view> source_line(std::string_view text, int number);

/// Other lines of the same function with the same return, where one stands at this place (both counted from 1): for a
/// compiler equal ones are one piece of code, and it takes its place from any of them. Functions end with a line that
/// begins with a brace.
[[nodiscard]] std::vector<int> equal_returns(std::string_view text, int line, int column);

/// May the line be shown as one that runs? Not one of braces, parentheses and `else`, where code for what ends there
/// stands, nor the head of a class, where that of functions stands which nobody wrote.
[[nodiscard]] bool says_what_runs(std::string_view line);

/// Does it decide something within itself, by && or || or ?: Then a place in it need not be the whole line's.
[[nodiscard]] bool decides_within(std::string_view line);

}
