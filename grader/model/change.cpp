#include "model/change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace umbral::grader {
namespace {

constexpr std::string_view gone = "---";
constexpr std::string_view come = "+++";

void add_line(std::string& text, const std::string& line, bool first)
{
    if (!first) text += '\n';
    text += line;
}

}

std::map<std::string, std::string> solution_header(std::string_view text)
{
    std::map<std::string, std::string> header;
    std::istringstream stream{std::string(text)};
    const bool in_comments = text.starts_with("//");
    std::string key;
    for (std::string line; std::getline(stream, line) && line != gone && line.starts_with("//") == in_comments;) {
        const std::size_t begin = line.find_first_not_of(in_comments ? "/ " : " ");
        if (begin == std::string::npos) continue;
        const std::string content = line.substr(begin);
        const std::size_t colon = content.find(": ");
        const std::string before = content.substr(0, colon);
        if (colon != std::string::npos && std::ranges::find(solution_keys, before) != std::end(solution_keys)) {
            key = before;
            header[key] = content.substr(colon + 2);
        } else if (!key.empty()) {
            header[key] += " " + content;
        } else if (!in_comments) {
            break;
        }
    }
    return header;
}

Change parse_change(const std::string& text, const std::string& where)
{
    Change change{solution_header(text), {}};
    std::istringstream stream(text);
    std::string* block = nullptr;
    bool first = true;
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        if (line == gone) {
            if (!change.steps.empty() && block == &change.steps.back().before)
                throw std::runtime_error(fmt::format("{}:{}: expected '{}' and the text that comes before another '{}'",
                                                     where, number, come, gone));
            block = &change.steps.emplace_back().before;
            first = true;
        } else if (line == come) {
            if (change.steps.empty() || block != &change.steps.back().before)
                throw std::runtime_error(
                    fmt::format("{}:{}: expected '{}' and the text that goes before '{}'", where, number, gone, come));
            block = &change.steps.back().after;
            first = true;
        } else if (block != nullptr) {
            add_line(*block, line, first);
            first = false;
        }
    }
    if (change.steps.empty() || block != &change.steps.back().after)
        throw std::runtime_error(fmt::format("{}: expected at least one '{}' with a '{}' after it", where, gone, come));
    return change;
}

std::string apply_change(const Change& change, std::string base, const std::string& where)
{
    for (const Change::Step& step : change.steps) {
        const std::size_t at = step.before.empty() ? std::string::npos : base.find(step.before);
        if (at == std::string::npos)
            throw std::runtime_error(fmt::format("{}: the text to change does not occur:\n{}", where, step.before));
        if (base.find(step.before, at + 1) != std::string::npos)
            throw std::runtime_error(
                fmt::format("{}: the text to change occurs more than once; give more of its surroundings:\n{}", where,
                            step.before));
        base.replace(at, step.before.size(), step.after);
    }
    return base;
}

}
