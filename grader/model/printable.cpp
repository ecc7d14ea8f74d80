#include <fmt/format.h>

#include <cstdint>

#include "model/recording.hpp"

namespace umbral::grader {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

struct Character {
    std::size_t size = 1;  ///< bytes taken from the text, at least 1
    char32_t code = 0;
    bool valid = false;
};

/// The character that `text` begins with. Over-long forms, surrogates and codes past U+10FFFF are invalid, and an invalid byte is
/// taken alone, so that what follows is read again.
Character first_character(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80) return {1, lead, true};
    const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return {};
    char32_t code = lead & (0x7FU >> size);
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return {};
        code = code << 6U | (byte(i) & 0x3FU);
    }
    constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    if (code < smallest[size] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {};
    return {size, code, true};
}

/// Control characters, and those that reorder or hide the text around them.
bool is_harmful(char32_t code)
{
    if (code == '\n' || code == '\t') return false;
    const auto within = [&](char32_t low, char32_t high) { return code >= low && code <= high; };
    return code < 0x20 || within(0x7F, 0x9F) || within(0x200E, 0x200F) || within(0x2028, 0x202E) || within(0x2066, 0x2069) || code == 0xFEFF;
}

}

std::string printable(std::string_view text, std::size_t limit)
{
    std::string result;
    while (!text.empty()) {
        const Character character = first_character(text);
        const std::string_view shown = character.valid && !is_harmful(character.code) ? text.substr(0, character.size) : replacement;
        if (shown.size() > limit - result.size()) return result + fmt::format("\n[cut here: {} more bytes]", text.size());
        result += shown;
        text.remove_prefix(character.size);
    }
    return result;
}

}
