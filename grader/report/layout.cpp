#include <algorithm>
#include <utility>

#include "report/layout.hpp"
#include "text/utf8.hpp"

namespace umbral::grader {
namespace {

/// The longest beginning of `text` that takes at most `width` cells, in bytes.
std::size_t bytes_within(std::string_view text, int width)
{
    std::size_t at = 0;
    int cells = 0;
    while (at < text.size()) {
        const Character character = first_character(text.substr(at));
        cells += cells_of(character.code);
        if (cells > width) break;
        at += character.size;
    }
    return at;
}

}

int display_width(std::string_view text)
{
    int cells = 0;
    while (!text.empty()) {
        if (text.starts_with("\x1b[")) {
            const std::size_t end = text.find('m');
            text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
            continue;
        }
        const Character character = first_character(text);
        cells += cells_of(character.code);
        text.remove_prefix(character.size);
    }
    return cells;
}

std::string pad(std::string_view text, int width, Align align)
{
    const std::string space(static_cast<std::size_t>(std::max(0, width - display_width(text))), ' ');
    return align == Align::left ? std::string(text) + space : space + std::string(text);
}

std::string shorten(std::string_view text, int width, std::string_view ellipsis)
{
    if (display_width(text) <= width) return std::string(text);
    const int room = width - display_width(ellipsis);
    if (room <= 0) return std::string(text.substr(0, bytes_within(text, std::max(0, width))));
    return std::string(text.substr(0, bytes_within(text, room))) + std::string(ellipsis);
}

std::vector<std::string_view> lines_of(std::string_view text)
{
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

std::vector<std::string> wrap(std::string_view text, int width)
{
    width = std::max(width, 2);  // a wide character must fit
    std::vector<std::string> result;
    for (std::string_view line : lines_of(text)) {
        do {
            std::size_t end = bytes_within(line, width);
            const std::size_t space = end < line.size() ? line.rfind(' ', end) : std::string_view::npos;
            if (space != std::string_view::npos && space > 0) end = space;
            result.emplace_back(line.substr(0, end));
            line.remove_prefix(end);
            if (line.starts_with(' ')) line.remove_prefix(1);
        } while (!line.empty());
    }
    return result;
}

std::vector<std::string> flow(const std::vector<std::string>& items, int width)
{
    std::vector<std::string> lines;
    for (const std::string& item : items) {
        const int needed = display_width(item) + 3;
        if (!lines.empty() && display_width(lines.back()) + needed <= width) {
            lines.back() += "   ";
            lines.back() += item;
        } else {
            for (std::string& line : wrap(item, width)) lines.push_back(std::move(line));
        }
    }
    return lines;
}

}
