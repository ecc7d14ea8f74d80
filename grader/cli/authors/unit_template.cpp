#include "cli/authors/unit_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "cli/application.hpp"
#include "collect/sources.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_word = 40;

bool is_letter(char letter) { return letter >= 'a' && letter <= 'z'; }
bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// Letters and digits, a letter first; with `hyphens` also single ones between them.
bool is_word(std::string_view word, bool hyphens)
{
    if (word.empty() || word.size() > longest_word || !is_letter(word.front()) || word.ends_with('-')) return false;
    if (word.find("--") != std::string_view::npos) return false;
    return std::ranges::all_of(
        word, [&](char letter) { return is_letter(letter) || is_digit(letter) || (hyphens && letter == '-'); });
}

/// A topic is a namespace's name as well.
bool is_keyword(const std::string& word)
{
    static const std::set<std::string> keywords{
        "alignas",  "alignof",   "and",      "asm",      "auto",    "bitand",   "bitor",    "bool",     "break",
        "case",     "catch",     "char",     "class",    "compl",   "concept",  "const",    "continue", "default",
        "delete",   "do",        "double",   "else",     "enum",    "explicit", "export",   "extern",   "false",
        "float",    "for",       "friend",   "goto",     "if",      "inline",   "int",      "long",     "main",
        "mutable",  "namespace", "new",      "noexcept", "not",     "nullptr",  "operator", "or",       "private",
        "public",   "register",  "requires", "return",   "short",   "signed",   "sizeof",   "static",   "std",
        "struct",   "switch",    "template", "this",     "throw",   "true",     "try",      "typedef",  "typeid",
        "typename", "union",     "unsigned", "using",    "virtual", "void",     "volatile", "while",    "xor",
        "glm",      "protected", "umbral",   "testing"};
    return keywords.contains(word);
}

std::string replaced(std::string text, std::string_view from, std::string_view to)
{
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

/// Which of two headers comes first depends on the topic's name.
std::string with_sorted_includes(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    const auto is_include = [](const std::string& line) { return line.starts_with("#include "); };
    for (auto begin = lines.begin(); begin != lines.end();) {
        begin = std::find_if(begin, lines.end(), is_include);
        const auto end = std::find_if_not(begin, lines.end(), is_include);
        std::sort(begin, end);
        begin = end;
    }
    std::string sorted;
    for (const std::string& line : lines) sorted += line + "\n";
    return sorted;
}

}

UnitName read_unit_name(const std::string& id)
{
    const std::size_t slash = id.find('/');
    const std::string topic = id.substr(0, slash);
    const std::string unit = slash == std::string::npos ? "" : id.substr(slash + 1);
    const auto refuse = [&](const std::string& expected) {
        throw UsageError(fmt::format("'{}' cannot be a unit's name: expected {}", one_line(id), expected));
    };
    if (!is_word(topic, false) || !is_word(unit, true))
        refuse(
            fmt::format("TOPIC/NAME as in transforms/two-frames: a-z and 0-9, a letter first, single hyphens inside "
                        "NAME only, at most {} characters each",
                        longest_word));
    if (is_keyword(topic))
        refuse(fmt::format("a topic that can be a namespace; '{}' means something else in C++", topic));
    if (unit == "driver") refuse("another name; the file driver.cpp is the unit's driver");
    if (unit.ends_with("-oracle")) refuse("a name without -oracle at its end; such a file is another unit's oracle");
    UnitName name{topic, unit, replaced(unit, "-", "_"), replaced(unit, "-", " "), ""};
    const auto large = [](char letter) { return static_cast<char>(std::toupper(static_cast<unsigned char>(letter))); };
    bool first = true;
    for (const char letter : unit) {
        if (letter != '-') name.test += first ? large(letter) : letter;
        first = letter == '-';
    }
    name.title.front() = large(name.title.front());
    return name;
}

std::string filled_in(std::string text, const UnitName& name)
{
    const std::pair<std::string_view, const std::string&> values[] = {{"@topic@", name.topic},
                                                                      {"@unit@", name.unit},
                                                                      {"@file@", name.file},
                                                                      {"@title@", name.title},
                                                                      {"@test@", name.test}};
    for (const auto& [mark, value] : values) text = replaced(std::move(text), mark, value);
    return text;
}

std::vector<NewFile> files_of_new_unit(const fs::path& templates, const UnitName& name)
{
    std::vector<NewFile> files;
    for (const auto& entry : fs::recursive_directory_iterator(templates)) {
        if (!entry.is_regular_file() || entry.path().extension() != ".in") continue;
        const fs::path file = filled_in(entry.path().lexically_relative(templates).replace_extension().string(), name);
        const bool is_cpp = file.extension() == ".cpp" || file.extension() == ".hpp";
        const std::string text = filled_in(read_text(entry.path()), name);
        files.push_back({file, is_cpp ? with_sorted_includes(text) : text});
    }
    std::ranges::sort(files, {}, &NewFile::name);
    return files;
}

}
