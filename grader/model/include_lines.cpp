#include "model/include_lines.hpp"

#include <algorithm>
#include <sstream>

namespace umbral::grader {
namespace {

/// What stands between the quotes or brackets of an include line; empty for any other line.
std::string_view included(std::string_view line)
{
    const auto skip_spaces = [&] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
    skip_spaces();
    if (!line.starts_with('#')) return {};
    line.remove_prefix(1);
    skip_spaces();
    if (!line.starts_with("include")) return {};
    line.remove_prefix(7);
    skip_spaces();
    if (line.empty() || (line.front() != '"' && line.front() != '<')) return {};
    const char closing = line.front() == '"' ? '"' : '>';
    line.remove_prefix(1);
    const std::size_t end = line.find(closing);
    return end == std::string_view::npos ? std::string_view() : line.substr(0, end);
}

}

std::vector<std::string> included_in(std::string_view text)
{
    std::vector<std::string> names;
    std::istringstream stream{std::string(text)};
    for (std::string line; std::getline(stream, line);)
        if (const std::string_view name = included(line); !name.empty()) names.emplace_back(name);
    return names;
}

std::vector<std::string> framework_includes(std::string_view text)
{
    std::vector<std::string> headers = included_in(text);
    std::erase_if(headers, [](const std::string& header) { return !header.starts_with("umbral/"); });
    return headers;
}

}
