#include "build/header_texts.hpp"

#include <filesystem>
#include <fstream>

#include "build/spelling.hpp"

namespace umbral::grader {
namespace {

/// Behind the bracket that closes the first of `text`; its end if there is none.
std::size_t behind_brackets(std::string_view text)
{
    int depth = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '<') ++depth;
        if (text[at] == '>' && --depth == 0) return at + 1;
    }
    return text.size();
}

}

std::string declared_name(std::string_view text)
{
    while (true) {
        std::size_t end = text.starts_with('~') ? 1 : 0;
        while (end < text.size() && is_word(text[end])) ++end;
        const std::string_view name = text.substr(0, end);
        text.remove_prefix(end);
        if (name != "operator" && text.starts_with('<')) text.remove_prefix(behind_brackets(text));
        if (!text.starts_with("::")) return std::string(name);
        text.remove_prefix(2);
    }
}

const std::vector<std::string>& HeaderTexts::lines_of(const std::string& file)
{
    const auto [entry, is_new] = files_.try_emplace(file);
    // All of GLM's are 2 MiB. What names the files came of hostile sources: they may be anything, and as many.
    constexpr std::uintmax_t most = std::uintmax_t{8} << 20U;
    std::error_code error;
    if (!is_new || !std::filesystem::is_regular_file(file, error)) return entry->second;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || size > most - bytes_) return entry->second;
    bytes_ += size;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) entry->second.push_back(line);
    return entry->second;
}

bool HeaderTexts::declares(const InspectedFunction& function)
{
    // Members that the compiler makes have the place of their class, and nothing but a member is called so.
    if (function.bare.starts_with('~') || function.bare == "operator=") return true;
    const std::vector<std::string>& lines = lines_of(function.file);
    if (function.line < 1 || function.column < 1 || static_cast<std::size_t>(function.line) > lines.size())
        return false;
    const std::string& line = lines[static_cast<std::size_t>(function.line) - 1];
    if (static_cast<std::size_t>(function.column) > line.size()) return false;
    const std::string written =
        declared_name(std::string_view(line).substr(static_cast<std::size_t>(function.column) - 1));
    return written == (function.bare.starts_with("operator") ? "operator" : function.bare);
}

}
