#include "text/utf8.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "text/combining_marks.hpp"

namespace umbral {
namespace {

// Unicode Standard Annex 11 (East Asian Width), with neighbouring blocks joined: enough to keep tables straight.
constexpr std::array wide = {
    CharacterRange{0x1100, 0x115F},   CharacterRange{0x2E80, 0x303E},   CharacterRange{0x3041, 0xA4CF},
    CharacterRange{0xAC00, 0xD7A3},   CharacterRange{0xF900, 0xFAFF},   CharacterRange{0xFE30, 0xFE6F},
    CharacterRange{0xFF00, 0xFF60},   CharacterRange{0xFFE0, 0xFFE6},   CharacterRange{0x1F300, 0x1F64F},
    CharacterRange{0x1F680, 0x1F6FF}, CharacterRange{0x1F900, 0x1F9FF}, CharacterRange{0x20000, 0x3FFFD}};

bool is_in(std::span<const CharacterRange> ranges, char32_t code)
{
    const auto found = std::ranges::lower_bound(ranges, code, {}, &CharacterRange::last);
    return found != ranges.end() && code >= found->first;
}

}

Character first_character(std::string_view text)
{
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    const char32_t lead = byte(0);
    if (lead < 0x80) return {lead, 1, true};
    const std::size_t size = lead >= 0xF0 && lead < 0xF5   ? 4
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                                                           : 0;
    if (size == 0 || text.size() < size) return {lead, 1, false};

    char32_t code = lead & (0x7FU >> size);
    for (std::size_t at = 1; at < size; ++at) {
        if ((byte(at) & 0xC0U) != 0x80U) return {lead, 1, false};
        code = (code << 6U) | (byte(at) & 0x3FU);
    }
    constexpr std::array<char32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
    if (code < least[size] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {lead, 1, false};
    return {code, size, true};
}

bool is_deceptive(char32_t code)
{
    // Unicode's properties Default_Ignorable_Code_Point and Bidi_Control, C1 controls, line separators, and marks of
    // annotations.
    constexpr std::array deceptive = {
        CharacterRange{0x80, 0x9F},       CharacterRange{0xAD, 0xAD},       CharacterRange{0x34F, 0x34F},
        CharacterRange{0x61C, 0x61C},     CharacterRange{0x115F, 0x1160},   CharacterRange{0x17B4, 0x17B5},
        CharacterRange{0x180B, 0x180F},   CharacterRange{0x200B, 0x200F},   CharacterRange{0x2028, 0x202E},
        CharacterRange{0x2060, 0x206F},   CharacterRange{0x3164, 0x3164},   CharacterRange{0xFE00, 0xFE0F},
        CharacterRange{0xFEFF, 0xFEFF},   CharacterRange{0xFFA0, 0xFFA0},   CharacterRange{0xFFF0, 0xFFFB},
        CharacterRange{0x1BCA0, 0x1BCA3}, CharacterRange{0x1D173, 0x1D17A}, CharacterRange{0xE0000, 0xE0FFF}};
    return is_in(deceptive, code);
}

int cells_of(char32_t code) { return is_in(combining_marks, code) ? 0 : is_in(wide, code) ? 2 : 1; }

}
