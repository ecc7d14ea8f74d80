#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace umbral {

/// One character of a UTF-8 text. What is not valid UTF-8 (also overlong forms and surrogates) comes byte by byte with
/// `valid` false.
struct Character {
    char32_t code = 0;
    std::size_t size = 1;
    bool valid = false;
};

/// The first character of `text`, which is not empty.
[[nodiscard]] Character first_character(std::string_view text);

/// Is it a byte that no character begins with?
[[nodiscard]] inline bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Does it change how its neighbours look, or can it not be seen? C1 controls, what turns the direction of writing
/// (Unicode's Bidi_Control), line separators, and characters without any picture: tools of deception in a report.
[[nodiscard]] bool is_deceptive(char32_t code);

/// How many terminal cells a character takes: 0 (combining), 1 or 2 (East Asian wide, most emoji).
[[nodiscard]] int cells_of(char32_t code);

}
