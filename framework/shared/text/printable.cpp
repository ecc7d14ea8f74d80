#include "text/printable.hpp"

#include <fmt/format.h>

#include "text/utf8.hpp"

namespace umbral {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

/// Control characters, and those that reorder or hide the text around them.
bool is_harmful(char32_t code)
{
    if (code == '\n' || code == '\t') return false;
    const auto within = [&](char32_t low, char32_t high) { return code >= low && code <= high; };
    return code < 0x20 || within(0x7F, 0x9F) || within(0x200E, 0x200F) || within(0x2028, 0x202E) ||
           within(0x2066, 0x2069) || code == 0xFEFF;
}

}

std::string printable(std::string_view text, std::size_t limit)
{
    std::string result;
    while (!text.empty()) {
        const Character character = first_character(text);
        const std::string_view shown =
            character.valid && !is_harmful(character.code) ? text.substr(0, character.size) : replacement;
        if (shown.size() > limit - result.size())
            return result + fmt::format("\n[cut here: {} more bytes]", text.size());
        result += shown;
        text.remove_prefix(character.size);
    }
    return result;
}

}
