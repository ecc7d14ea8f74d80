#include "cli/authors/interface_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "collect/sources.hpp"
#include "model/include_lines.hpp"
#include "report/layout.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

constexpr std::string_view begin_mark = "<!-- interface ";
constexpr std::string_view begin_end = " -->";
constexpr std::string_view end_mark = "<!-- /interface -->";

Lines own_lines(std::string_view text)
{
    const std::vector<std::string_view> lines = lines_of(text);
    return {lines.begin(), lines.end()};
}

std::string joined(const Lines& lines)
{
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find("//")); }

/// Parts of a text between empty lines outside of all braces: declarations with the comments before them.
std::vector<Lines> parts_of(const Lines& lines)
{
    std::vector<Lines> parts;
    std::ptrdiff_t depth = 0;
    bool open = false;
    for (const std::string& line : lines) {
        const std::string_view code = without_comment(line);
        depth += std::ranges::count(code, '{') - std::ranges::count(code, '}');
        if (line.empty() && depth == 0) {
            open = false;
            continue;
        }
        if (!open) parts.emplace_back();
        open = true;
        parts.back().push_back(line);
    }
    return parts;
}

std::string joined(const std::vector<Lines>& parts)
{
    std::string text;
    for (const Lines& part : parts) text += (text.empty() ? "" : "\n") + joined(part);
    return text;
}

std::vector<std::string> words_of(std::string_view code)
{
    std::vector<std::string> words(1);
    for (const char c : code)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
    if (words.back().empty()) words.pop_back();
    return words;
}

/// The name that a part declares: a type's, or a function's. Empty if it is a comment only.
std::string declared_in(const Lines& part)
{
    std::string code;
    for (const std::string& line : part)
        if (!without_comment(line).empty()) code += std::string(without_comment(line)) + " ";
    if (code.starts_with("template")) code.erase(0, code.find('>') + 1);
    const std::vector<std::string> words = words_of(std::string_view(code).substr(0, code.find_first_of("({;=")));
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] == "enum" && words[i + 1] == "class") continue;
        if (words[i] == "struct" || words[i] == "class" || words[i] == "enum" || words[i] == "using")
            return words[i + 1];
    }
    return words.empty() ? "" : words.back();
}

/// Private members are no business of who calls or writes the unit.
void drop_private(Lines& part)
{
    const auto from = std::ranges::find(part, "private:");
    const auto to = std::find(from, part.end(), "};");
    auto first = from;
    while (first != part.begin() && to != part.end() && (first - 1)->empty()) --first;
    if (to != part.end()) part.erase(first, to);
}

std::string namespace_of(const std::string& header)
{
    for (const std::string& line : own_lines(header))
        if (line.starts_with("namespace ")) return line.substr(10, line.find(" {") - 10);
    return "";
}

/// The line that begins a block, taken apart.
struct Mark {
    std::string file;
    std::vector<std::string> names;
};

Mark mark_in(std::string_view line)
{
    line.remove_prefix(begin_mark.size());
    line.remove_suffix(begin_end.size());
    const std::size_t colon = std::min(line.find(':'), line.size());
    return {std::string(line.substr(0, colon)), words_of(line.substr(colon))};
}

bool begins_block(std::string_view line) { return line.starts_with(begin_mark) && line.ends_with(begin_end); }

std::string code_block(const Mark& mark, const InterfaceSources& sources)
{
    const bool header = mark.file.find('/') != std::string::npos;
    const std::string text = read_text((header ? sources.framework : sources.exercise.folder) / mark.file);
    if (!header) return fmt::format("```glsl\n// {}\n{}```\n", mark.file, shown_of_shader(text));
    return fmt::format("```cpp\n// <{}>, namespace {}\n\n{}```\n", mark.file, namespace_of(text),
                       shown_of_header(text, mark.names));
}

/// The place of a section's end: of the next one's heading, or the text's end.
Lines::iterator next_section(Lines& lines, Lines::iterator from)
{
    return std::find_if(from, lines.end(), [](const std::string& line) { return line.starts_with("## "); });
}

/// Puts an empty block for `file` at the end of the section of interfaces.
void add_block(Lines& lines, const std::string& heading, const std::string& file)
{
    auto section = std::ranges::find(lines, heading);
    if (section == lines.end()) {
        const auto first = next_section(lines, lines.begin());
        section = lines.insert(next_section(lines, first == lines.end() ? first : first + 1), {heading, ""});
    }
    const Lines block{fmt::format("{}{}{}", begin_mark, file, begin_end), std::string(end_mark), ""};
    lines.insert(next_section(lines, section + 1), block.begin(), block.end());
}

}

std::vector<std::string> interface_files(const Exercise& exercise)
{
    std::vector<std::string> files;
    const auto add = [&](const std::string& file) {
        if (std::ranges::find(files, file) == files.end()) files.push_back(file);
    };
    for (const std::string& stub : exercise.files)
        if (!stub.ends_with(".cpp") && !stub.ends_with(".hpp")) add(stub);
    for (const std::string& header : exercise.interfaces)
        if (header.starts_with("umbral/" + exercise.topic + "/")) add(header);
    return files;
}

std::string shown_of_header(std::string_view text, const std::vector<std::string>& names)
{
    Lines lines = own_lines(text);
    std::erase_if(lines, [](const std::string& line) {
        return line.starts_with("#pragma once") || line.starts_with("#include");
    });
    // The block's first line names the outer namespace; one within it is part of what must be written.
    const auto opening = std::ranges::find_if(
        lines, [](const std::string& line) { return line.starts_with("namespace ") && line.ends_with("{"); });
    if (opening != lines.end()) {
        lines.erase(opening);
        const auto closing = std::find(lines.rbegin(), lines.rend(), "}");
        if (closing != lines.rend()) lines.erase(std::next(closing).base());
    }
    std::vector<Lines> parts = parts_of(lines);
    for (const std::string& name : names)
        if (std::ranges::find(parts, name, declared_in) == parts.end())
            throw std::runtime_error(fmt::format("nothing called {} is declared there", name));
    if (!names.empty())
        std::erase_if(parts,
                      [&](const Lines& part) { return std::ranges::find(names, declared_in(part)) == names.end(); });
    for (Lines& part : parts) drop_private(part);
    return joined(parts);
}

std::string shown_of_shader(std::string_view text)
{
    std::vector<Lines> parts = parts_of(own_lines(text.substr(0, text.find("\nvoid main()"))));
    // A comment that declares nothing tells what is left to write.
    std::erase_if(parts, [](const Lines& part) { return declared_in(part).empty(); });
    return joined(parts);
}

std::string with_interfaces(const std::string& statement, const std::string& heading, const InterfaceSources& sources)
{
    Lines lines = own_lines(statement);
    for (const std::string& file : interface_files(sources.exercise)) {
        const auto shows = [&](const std::string& line) { return begins_block(line) && mark_in(line).file == file; };
        if (std::ranges::none_of(lines, shows)) add_block(lines, heading, file);
    }
    std::string result;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        result += lines[i] + "\n";
        if (!begins_block(lines[i])) continue;
        const std::size_t begin = i;
        while (++i < lines.size() && lines[i] != end_mark)
            if (begins_block(lines[i])) i = lines.size();
        if (i >= lines.size())
            throw std::runtime_error(fmt::format("line {}: expected a line {} behind it", begin + 1, end_mark));
        try {
            result += code_block(mark_in(lines[begin]), sources);
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(fmt::format("line {}: {}: {}", begin + 1, lines[begin], error.what()));
        }
        result += lines[i] + "\n";
    }
    return result;
}

}
