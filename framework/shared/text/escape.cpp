#include "text/escape.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "text/utf8.hpp"

namespace umbral {
namespace {

std::string control_picture(char32_t code, bool unicode)
{
    if (!unicode) return {'^', static_cast<char>(code == 0x7F ? '?' : '@' + code)};
    const char32_t picture = code == 0x7F ? 0x2421 : 0x2400 + code;
    return {'\xE2', '\x90', static_cast<char>(0x80U | (picture & 0x3FU))};
}

/// What messages of our own use beyond ASCII, and its nearest spelling.
std::string in_ascii(char32_t code)
{
    constexpr std::array<std::pair<char32_t, std::string_view>, 14> spellings = {{{0x2026, "..."},
                                                                                  {0x2013, "-"},
                                                                                  {0x2014, "-"},
                                                                                  {0x2212, "-"},
                                                                                  {0xB7, "."},
                                                                                  {0xD7, "x"},
                                                                                  {0xB1, "+-"},
                                                                                  {0xB2, "^2"},
                                                                                  {0xB0, " degrees"},
                                                                                  {0x2018, "'"},
                                                                                  {0x2019, "'"},
                                                                                  {0x201C, "\""},
                                                                                  {0x201D, "\""},
                                                                                  {0x2264, "<="}}};
    for (const auto& [character, spelling] : spellings)
        if (character == code) return std::string(spelling);
    return fmt::format("<U+{:04X}>", static_cast<unsigned>(code));
}

}

std::string escape_terminal(std::string_view text, TerminalText keep)
{
    std::string result;
    result.reserve(text.size());
    int column = 0;
    const auto add = [&](std::string_view piece, int cells) {
        result += piece;
        column += cells;
    };
    while (!text.empty()) {
        const Character character = first_character(text);
        const std::string_view piece = text.substr(0, character.size);
        const char32_t code = character.code;
        if (!character.valid) {
            add(fmt::format("<{:02X}>", static_cast<unsigned>(code)), 4);
        } else if (keep.lines && text.starts_with("\r\n")) {
            // The line feed that follows says it all.
        } else if (keep.lines && code == '\n') {
            result += '\n';
            column = 0;
        } else if (code == '\t') {
            add(std::string(static_cast<std::size_t>(4 - column % 4), ' '), 4 - column % 4);
        } else if (code < 0x20 || code == 0x7F) {
            add(control_picture(code, keep.unicode), keep.unicode ? 1 : 2);
        } else if (is_deceptive(code)) {
            add(fmt::format("<U+{:04X}>", static_cast<unsigned>(code)), 8);
        } else if (code >= 0x80 && !keep.unicode) {
            const std::string spelling = in_ascii(code);
            add(spelling, static_cast<int>(spelling.size()));
        } else {
            add(piece, cells_of(code));
        }
        text.remove_prefix(character.size);
    }
    return result;
}

std::string escape_html(std::string_view text)
{
    std::string result;
    for (const char c : escape_terminal(text, {.lines = true, .unicode = true})) {
        switch (c) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            case '\'': result += "&#39;"; break;
            default: result += c;
        }
    }
    return result;
}

}
