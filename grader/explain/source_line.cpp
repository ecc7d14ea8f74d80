#include "explain/source_line.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace umbral::grader {
namespace {

/// Calls `look` with this line and those behind or before it, until the function ends; with so many at most, since each
/// is looked for from the file's beginning.
template <class Look>
void each_line_of_function(std::string_view text, int line, int step, const Look& look)
{
    constexpr int most_lines = 100;
    for (int number = line; std::abs(number - line) < most_lines; number += step) {
        const std::optional<std::string_view> one = source_line(text, number);
        if (!one || one->starts_with('}')) return;
        look(number, *one);
    }
}

}

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

std::vector<int> equal_returns(std::string_view text, int line, int column)
{
    constexpr std::string_view word = "return";
    const std::optional<std::string_view> here = source_line(text, line);
    if (!here || column < 1 || static_cast<std::size_t>(column) > here->size()) return {};
    std::string_view statement = here->substr(static_cast<std::size_t>(column) - 1);
    statement = statement.substr(0, statement.find(';') + 1);
    if (!statement.starts_with(word) || !statement.ends_with(';')) return {};
    std::vector<int> found;
    for (const int step : {-1, 1})
        each_line_of_function(text, line + step, step, [&](int number, std::string_view one) {
            if (one.find(statement) != std::string_view::npos) found.push_back(number);
        });
    std::ranges::sort(found);
    return found;
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
