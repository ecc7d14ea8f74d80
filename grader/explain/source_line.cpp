#include "explain/source_line.hpp"

#include <algorithm>
#include <array>

namespace umbral::grader {

std::optional<std::string_view> source_line(std::string_view text, int number)
{
    if (number < 1) return std::nullopt;
    for (int line = 1; line < number; ++line) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return std::nullopt;
        text.remove_prefix(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    while (text.ends_with('\r')) text.remove_suffix(1);
    return text;
}

bool says_what_runs(std::string_view line)
{
    constexpr std::string_view beside = " \t(){}[];,";
    line.remove_prefix(std::min(line.find_first_not_of(beside), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(" \t(){}[];,:/"));
    if (word.empty()) return false;
    constexpr std::array heads = {"class", "struct", "union", "namespace", "public", "private", "protected"};
    if (std::ranges::find(heads, word) != heads.end()) return false;
    return word != "else" || line.find_first_not_of(beside, word.size()) != std::string_view::npos;
}

bool decides_within(std::string_view line)
{
    constexpr std::array words = {"&&", "||", " ? "};
    return std::ranges::any_of(words, [&](const char* word) { return line.find(word) != std::string_view::npos; });
}

}
