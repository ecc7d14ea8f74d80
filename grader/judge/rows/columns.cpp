#include "judge/rows/columns.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "judge/rows/gl_words.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_letters = 4;
constexpr std::string_view nameless = "-";
constexpr std::size_t most_in_group = 64;

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\n')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\n')) text.remove_suffix(1);
    return text;
}

/// "colour/4" as its name and how many it names.
ColumnGroup group_of(std::string_view item, std::size_t first)
{
    const std::size_t slash = item.rfind('/');
    if (slash == std::string_view::npos) return {std::string(item), first, 1};
    std::size_t size = 0;
    const auto [end, error] = std::from_chars(item.data() + slash + 1, item.data() + item.size(), size);
    const bool is_number = error == std::errc() && end == item.data() + item.size();
    if (!is_number || size == 0 || size > most_in_group) return {std::string(item), first, 1};
    return {std::string(item.substr(0, slash)), first, size};
}

/// What the numbers of a vector are called, of which the last word of its name may say that it is a colour.
std::string_view letters_of(std::string_view name, std::size_t size)
{
    const std::string_view word = name.substr(name.rfind(' ') + 1);
    constexpr std::string_view colors[] = {"color", "colors", "colour", "colours", "light", "highlight", "radiance"};
    return size > 2 && std::ranges::find(colors, word) != std::end(colors) ? "rgba" : "xyzw";
}

}

std::vector<ColumnGroup> column_groups(std::string_view text, std::size_t components)
{
    std::vector<ColumnGroup> groups;
    std::size_t next = 0;
    while (!trimmed(text).empty()) {
        const std::string_view item = text.substr(0, text.find(','));
        text.remove_prefix(std::min(item.size() + 1, text.size()));
        groups.push_back(group_of(trimmed(item), next));
        next += groups.back().size;
    }
    if (next != components) return {};
    std::erase_if(groups, [](const ColumnGroup& group) { return group.name == nameless; });
    return groups;
}

std::vector<std::string> column_names(std::string_view text, std::size_t components, std::string_view value)
{
    std::vector<std::string> names(components);
    const std::vector<ColumnGroup> groups = column_groups(text, components);
    for (const ColumnGroup& group : groups)
        for (std::size_t i = 0; i < group.size; ++i)
            names[group.first + i] = group.size == 1 ? group.name
                                     : group.size <= most_letters
                                         ? group.name + "." + letters_of(group.name, group.size)[i]
                                         : group.name + "[" + std::to_string(i) + "]";
    if (!groups.empty()) return names;
    if (components < 2 || components > most_letters) return {};
    for (std::size_t i = 0; i < components; ++i) names[i] = letters_of(value, components)[i];
    return names;
}

ColumnWord column_word(std::string_view column, double value)
{
    const std::size_t open = column.find(" (");
    if (open == std::string_view::npos || !column.ends_with(')'))
        return {std::string(column), std::string(gl_word(column, value))};
    std::string word;
    std::string_view words = column.substr(open + 2, column.size() - open - 3);
    while (!words.empty()) {
        const std::string_view entry = trimmed(words.substr(0, words.find(';')));
        words.remove_prefix(std::min(words.find(';'), words.size() - 1) + 1);
        const std::size_t colon = std::min(entry.find(": "), entry.size());
        int code = 0;
        const auto [end, error] = std::from_chars(entry.data(), entry.data() + colon, code);
        if (error != std::errc() || end != entry.data() + colon || colon == entry.size())
            return {std::string(column), ""};
        if (value == code) word = entry.substr(colon + 2);
    }
    return {std::string(column.substr(0, open)), std::move(word)};
}

}
