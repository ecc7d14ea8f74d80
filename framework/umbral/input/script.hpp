#pragma once

#include <string>
#include <string_view>
#include <umbral/input/events.hpp>

namespace umbral::input {

/// Reads an event script, one event a line, first its time in seconds. A `#` begins a comment. What can happen:
///
///     0.10 press left 120 80      a mouse button (left, right, middle, 4 … 8), with or without a place
///     0.15 move 140 85            the pointer, in screen coordinates, y downwards
///     0.20 release left
///     0.30 scroll 0 -1            steps in x and y
///     0.40 key R press            press, repeat or release; names of keys: see key_of
///     0.41 char 241               a composed character, as a Unicode number
///     0.50 resize 800 600
///     0.60 focus off              on or off; so too: enter, iconify
///     0.70 refresh
///     0.80 close
///
/// Throws std::invalid_argument that names `where` and the line, what was expected and what came.
[[nodiscard]] EventScript parse_script(std::string_view text, const std::string& where = "event script");

/// The script that parse_script reads back as these events, to the last digit.
[[nodiscard]] std::string to_text(const EventScript& script);

}
