#include "text/printable.hpp"

#include <fmt/format.h>

#include "text/utf8.hpp"

namespace umbral {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

/// So many marks may stand on one letter: no language has more, and more reach over the lines above and below.
constexpr int most_marks = 4;

/// Control characters, and those that reorder or hide the text around them.
bool is_harmful(char32_t code)
{
    if (code == '\n' || code == '\t') return false;
    return code < 0x20 || code == 0x7F || is_deceptive(code);
}

}

std::string printable(std::string_view text, std::size_t limit)
{
    std::string result;
    int marks = 0;
    while (!text.empty()) {
        const Character character = first_character(text);
        marks = character.valid && cells_of(character.code) == 0 ? marks + 1 : 0;
        const bool harmful = !character.valid || is_harmful(character.code) || marks > most_marks;
        const std::string_view shown = harmful ? replacement : text.substr(0, character.size);
        if (shown.size() > limit - result.size())
            return result + fmt::format("\n[cut here: {} more bytes]", text.size());
        result += shown;
        text.remove_prefix(character.size);
    }
    return result;
}

}
