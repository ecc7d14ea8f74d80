#include "build/compiler_text.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "build/machine_trouble.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// The linker names what the compiler hands it, whose names are new each time ("cc7WsPYa.o"): equal work gets equal
/// messages.
void name_objects(std::string& text)
{
    constexpr std::string_view name = "cc??????.o";
    constexpr std::string_view shown = "object file";
    for (std::size_t at = text.find("cc"); at != std::string::npos; at = text.find("cc", at + 1)) {
        const auto fits = [&](std::size_t i) {
            const char c = text[at + i];
            return name[i] == '?' ? std::isalnum(static_cast<unsigned char>(c)) != 0 : c == name[i];
        };
        std::size_t i = 0;
        while (i < name.size() && at + i < text.size() && fits(i)) ++i;
        if (i == name.size()) text.replace(at, name.size(), shown);
    }
}

}

std::string first_errors(std::string_view output, std::size_t lines)
{
    std::string kept;
    std::istringstream stream{std::string(output)};
    std::size_t count = 0;
    bool relevant = false;
    for (std::string line; std::getline(stream, line);) {
        // A message begins a block ("sphere.cpp:3:5: error: …"); source lines and notes follow it.
        if (line.find(": error:") != std::string::npos || line.find(": Error: ") != std::string::npos ||
            line.find("undefined reference") != std::string::npos || line.find("duplicate symbol") != std::string::npos)
            relevant = true;
        else if (line.find(": warning:") != std::string::npos)
            relevant = false;
        if (!relevant) continue;
        if (++count > lines) return kept + "…\n";
        kept += line + '\n';
    }
    return kept;
}

std::string warnings_of(const std::string& output)
{
    std::string kept;
    std::istringstream stream(output);
    for (std::string line; std::getline(stream, line);)
        if (line.find(": warning: ") != std::string::npos) kept += line + '\n';
    return kept;
}

bool tells_of_processor_time(std::string_view output, std::string_view compiler)
{
    for (const char* const kind : {"fatal error", "internal compiler error"})
        if (has_line_beginning(
                output, std::string(compiler) + ": " + kind + ": CPU time limit exceeded signal terminated program "))
            return true;
    return false;
}

bool blames_own_file(std::string_view output, const Sources& files)
{
    std::istringstream stream{std::string(output)};
    const auto is_error = [](const std::string& line, std::size_t from) {
        return line.find(" error: ", from) != std::string::npos;
    };
    for (std::string line; std::getline(stream, line);) {
        for (const auto& [name, text] : files)
            if (line.starts_with(name + ":") && is_error(line, name.size())) return true;
    }
    return false;
}

std::string without_folders(std::string text, const std::vector<fs::path>& folders)
{
    for (const fs::path& folder : folders) {
        const std::string prefix = folder.string() + "/";
        for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at))
            text.erase(at, prefix.size());
    }
    // Where a line begins with a file, as it was given to the compiler.
    for (std::size_t at = 0; at != std::string::npos; at = text.find('\n', at + 1)) {
        const std::size_t begin = at == 0 ? 0 : at + 1;
        if (text.compare(begin, 2, "./") == 0) text.erase(begin, 2);
    }
    name_objects(text);
    return text;
}

}
