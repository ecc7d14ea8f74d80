#include "model/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

namespace umbral::grader {
namespace {

constexpr std::size_t longest_word = 64;

char small(char letter) { return static_cast<char>(std::tolower(static_cast<unsigned char>(letter))); }

std::string small(std::string_view word)
{
    std::string result(word);
    std::ranges::transform(result, result.begin(), [](char letter) { return small(letter); });
    return result;
}

/// How many letters two names begin with alike, up to the last '/' in that: a topic that was spelt right says nothing
/// of how much of the unit's name was.
std::size_t shared_folders(std::string_view word, std::string_view name)
{
    std::size_t shared = 0;
    for (std::size_t i = 0; i < std::min(word.size(), name.size()) && small(word[i]) == small(name[i]); ++i)
        if (word[i] == '/') shared = i + 1;
    return shared;
}

/// Those that lie at most a third of the letters away, the nearest first.
std::vector<std::string> mistyped(std::string_view word, std::span<const std::string> known)
{
    std::vector<std::pair<std::size_t, std::string>> found;
    for (const std::string& name : known) {
        const std::string_view written = word.substr(shared_folders(word, name));
        const std::string_view meant = std::string_view(name).substr(word.size() - written.size());
        const std::size_t distance = edit_distance(written, meant);
        if (distance <= std::max<std::size_t>(1, written.size() / 3)) found.emplace_back(distance, name);
    }
    std::ranges::stable_sort(found, {}, [](const auto& one) { return one.first; });
    std::vector<std::string> names;
    for (const auto& [distance, name] : found) names.push_back(name);
    return names;
}

std::vector<std::string> holding(std::string_view word, std::span<const std::string> known)
{
    std::vector<std::string> names;
    if (word.size() < 3) return names;
    std::ranges::copy_if(known, std::back_inserter(names),
                         [&](const std::string& name) { return small(name).find(small(word)) != std::string::npos; });
    return names;
}

}

std::size_t edit_distance(std::string_view a, std::string_view b)
{
    // Three rows of the table: of two letters ago, of the last one, of this one.
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(last);
        last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = small(a[i - 1]) == small(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && small(a[i - 1]) == small(b[j - 2]) && small(a[i - 2]) == small(b[j - 1]))
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::vector<std::string> nearest(std::string_view word, std::span<const std::string> known, std::size_t most)
{
    if (word.empty() || word.size() > longest_word) return {};
    std::vector<std::string> names;
    std::vector<std::string> found = mistyped(word, known);
    if (found.empty()) found = holding(word, known);
    for (const std::string& name : found)
        if (names.size() < most && std::ranges::find(names, name) == names.end()) names.push_back(name);
    return names;
}

std::string did_you_mean(std::span<const std::string> names)
{
    if (names.empty()) return ";";
    std::string text = "; did you mean ";
    for (std::size_t i = 0; i < names.size(); ++i) {
        text += i == 0 ? "`" : i + 1 == names.size() ? " or `" : ", `";
        text += names[i] + "`";
    }
    return text + "?";
}

}
