#include "model/caps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "model/recording.hpp"
#include "text/printable.hpp"

namespace umbral::grader {

std::string one_line(std::string_view text, std::size_t limit)
{
    // A character of four bytes may become a replacement of three: what is cut before is never too little.
    const bool cut = text.size() > limit;
    std::string line = printable(text.substr(0, limit), 3 * limit);
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\t'; }, ' ');
    if (line.size() > limit) {
        line.resize(limit);
        // Not within a character.
        while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xC0U) == 0x80U) line.pop_back();
        if (!line.empty() && (static_cast<unsigned char>(line.back()) & 0x80U) != 0) line.pop_back();
    } else if (!cut) {
        return line;
    }
    return line + "…";
}

std::string listed(std::span<const std::string> names)
{
    std::vector<std::string> shown;
    for (const std::string& one : names.first(std::min(names.size(), caps::listed))) shown.push_back(one_line(one));
    std::string text = fmt::format("{}", fmt::join(shown, ", "));
    if (names.size() > caps::listed) text += fmt::format(" and {} more", names.size() - caps::listed);
    return text;
}

}
