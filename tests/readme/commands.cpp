#include "readme/commands.hpp"

#include <regex>
#include <sstream>

namespace umbral::test {
namespace {

std::string trimmed(const std::string& text)
{
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

void add_quoted(std::vector<Command>& commands, const std::string& text, int line)
{
    static const std::regex quoted("`([^`]+)`");
    for (std::sregex_iterator at(text.begin(), text.end(), quoted), end; at != end; ++at)
        if (const std::string inside = trimmed((*at)[1]); calls_umbral(inside)) commands.push_back({inside, line, -1});
}

}

bool calls_umbral(std::string_view text)
{
    static const std::regex form(R"(([A-Z_]+=(\$\([^)]*\)|[^ ]*) +)*((\./)?umbral +[^ ].*|build/[^ ]*/bin/[^ ]+.*))");
    return std::regex_match(text.begin(), text.end(), form);
}

std::vector<Command> commands_of(std::string_view page)
{
    std::vector<Command> commands;
    std::istringstream stream{std::string(page)};
    int number = 0;
    int block = -1;
    bool inside = false;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        if (line.starts_with("```")) {
            inside = !inside;
            if (inside) ++block;
            continue;
        }
        if (!inside) {
            add_quoted(commands, line, number);
            continue;
        }
        const std::size_t comment = line.find(" #");
        const std::string text = trimmed(line.substr(0, comment));
        if (calls_umbral(text) || text.starts_with("cd ")) commands.push_back({text, number, block});
        if (comment != std::string::npos) add_quoted(commands, line.substr(comment), number);
    }
    return commands;
}

}
