#include "manifest/statement_table.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace umbral::grader {
namespace {

constexpr std::string_view heading = "## What is checked";

std::string trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

/// The cells of "| a | b |"; an escaped bar belongs to its cell.
std::vector<std::string> cells_of(std::string_view line)
{
    std::vector<std::string> cells(1);
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|')
            cells.back() += line[++i];
        else if (line[i] == '|')
            cells.emplace_back();
        else
            cells.back() += line[i];
    }
    if (trimmed(cells.back()).empty()) cells.pop_back();
    for (std::string& cell : cells) cell = trimmed(cell);
    return cells;
}

/// "[words](place)" becomes "words".
std::string without_links(std::string text)
{
    for (std::size_t at = 0; (at = text.find("](", at)) != std::string::npos;) {
        const std::size_t begin = text.rfind('[', at);
        const std::size_t end = text.find(')', at);
        if (begin == std::string::npos || end == std::string::npos) break;
        text = text.substr(0, begin) + text.substr(begin + 1, at - begin - 1) + text.substr(end + 1);
    }
    return text;
}

/// Without what stands in parentheses: "random (hidden) boxes" becomes "random boxes".
std::string without_parentheses(std::string text)
{
    for (std::size_t begin = 0; (begin = text.find(" (")) != std::string::npos;) {
        const std::size_t end = text.find(')', begin);
        if (end == std::string::npos) break;
        text.erase(begin, end - begin + 1);
    }
    return text;
}

/// Where `name` ends in the line's name, if one of `ends` or nothing follows; npos if it does not stand there.
std::size_t end_of_name(const std::string& line, std::string_view name, std::string_view ends)
{
    for (std::size_t at = 0; (at = line.find(name, at)) != std::string::npos; ++at) {
        const std::size_t end = at + name.size();
        const bool begins = at == 0 || line[at - 1] == ' ';
        if (begins && (end == line.size() || ends.find(line[end]) != std::string_view::npos)) return end;
    }
    return std::string::npos;
}

bool names(const std::string& line, std::string_view name, std::string_view ends)
{
    return end_of_name(line, name, ends) != std::string::npos;
}

/// "known, random boxes" names the cases "known boxes" and "random boxes": are all of several words there?
bool names_words(const std::string& line, const std::string& name)
{
    std::istringstream words(name);
    std::size_t count = 0;
    for (std::string word; words >> word; ++count)
        if (!names(line, word, ",;:/ ")) return false;
    return count > 1;
}

}

std::vector<StatementLine> statement_lines(std::string_view statement)
{
    std::vector<StatementLine> lines;
    const std::size_t begin = statement.find(heading);
    if (begin == std::string_view::npos) return lines;
    std::istringstream stream{std::string(statement.substr(begin + heading.size()))};
    std::size_t number = 0;
    for (std::string line; std::getline(stream, line) && !line.starts_with("## ");) {
        // The first two lines of a table are its head.
        if (!line.starts_with('|') || ++number <= 2) continue;
        const std::vector<std::string> cells = cells_of(line);
        if (cells.size() < 2) continue;
        std::string text = without_links(cells.back());
        if (!lines.empty() && text == "likewise") text = lines.back().text;
        if (!lines.empty() && (text.starts_with("the same") || text.starts_with("likewise")))
            text = lines.back().text + "; " + text;
        lines.push_back({without_parentheses(cells.front()), std::move(text)});
    }
    return lines;
}

std::string statement_says(const std::vector<StatementLine>& lines, std::string_view case_name, std::string_view value)
{
    const std::string name(case_name);
    const std::array exact{name, name + "/" + std::string(value), name + ": " + std::string(value)};
    for (const StatementLine& line : lines)
        if (std::ranges::find(exact, line.name) != exact.end()) return line.text;
    // "frames: end, alive" is about two values of a case, and another line about others.
    constexpr std::string_view before_values = ":/";
    constexpr std::string_view after_one = ",;:/ ";
    std::size_t in_parts = 0;
    for (const StatementLine& line : lines) {
        const std::size_t end = end_of_name(line.name, name, before_values);
        if (end >= line.name.size()) continue;
        ++in_parts;
        if (names(line.name.substr(end + 1), value, after_one)) return line.text;
    }
    for (const StatementLine& line : lines)
        if (names(line.name, name, in_parts > 1 ? ",;" : ",;:/")) return line.text;
    for (const StatementLine& line : lines)
        if (names_words(line.name, name)) return line.text;
    return "";
}

}
