#include <algorithm>
#include <sstream>
#include <umbral/gl/shader_log.hpp>

namespace umbral::gl {
namespace {

/// Takes the digits at the start of `text` away and returns them.
std::string_view take_number(std::string_view& text)
{
    const auto end = std::find_if(text.begin(), text.end(), [](char letter) { return letter < '0' || letter > '9'; });
    const std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(number.size());
    return number;
}

bool take(std::string_view& text, std::string_view expected)
{
    if (!text.starts_with(expected)) return false;
    text.remove_prefix(expected.size());
    return true;
}

// By hand, because std::regex would export its tables from this library.
std::string renamed(std::string_view line, std::string_view file)
{
    std::string_view rest = line;
    if (take_number(rest).empty()) return std::string(line);
    std::string_view number;
    if (take(rest, ":")) {  // Mesa: source:line(column): message
        number = take_number(rest);
        if (!take(rest, "(") || take_number(rest).empty() || !take(rest, ")")) return std::string(line);
    } else if (take(rest, "(")) {  // others: source(line) : message
        number = take_number(rest);
        if (!take(rest, ")")) return std::string(line);
        take(rest, " ");
    }
    if (number.empty() || !take(rest, ":")) return std::string(line);
    take(rest, " ");
    return std::string(file).append(":").append(number).append(": ").append(rest);
}

}

std::string with_file_name(std::string_view log, std::string_view file)
{
    constexpr int maximum_lines = 20;
    std::istringstream lines{std::string(log)};
    std::string result;
    int count = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || ++count > maximum_lines) continue;
        if (!result.empty()) result += '\n';
        result += renamed(line, file);
    }
    if (count > maximum_lines)
        result.append("\n… and ").append(std::to_string(count - maximum_lines)).append(" lines more");
    return result;
}

}
