#include "question/names.hpp"

#include <array>
#include <cctype>
#include <charconv>

namespace umbral::grader {
namespace {

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Behind its comments nothing of a header looks like a declaration and is none.
std::string without_comments(std::string_view text)
{
    std::string code;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
            code += '\n';
        } else {
            code += text[i];
        }
    }
    return code;
}

/// The last name in "const Ray& ray" or "float t = 0"; empty in "const Ray&".
std::string name_in(std::string_view parameter)
{
    parameter = parameter.substr(0, parameter.find('='));
    while (!parameter.empty() && !is_letter(parameter.back())) {
        if (parameter.back() == '&' || parameter.back() == '*' || parameter.back() == '>') return "";
        parameter.remove_suffix(1);
    }
    std::size_t first = parameter.size();
    while (first > 0 && is_letter(parameter[first - 1])) --first;
    const bool is_type = parameter.find_first_not_of(" \n\t") >= first;
    return is_type ? "" : std::string(parameter.substr(first));
}

/// Names in the list that begins behind an opening bracket.
std::vector<std::string> names_in(std::string_view list)
{
    std::vector<std::string> names;
    int depth = 0;
    std::size_t from = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const char c = list[i];
        const bool ends = c == ')' && depth == 0;
        if (ends || (c == ',' && depth == 0)) {
            const std::string_view parameter = list.substr(from, i - from);
            if (parameter.find_first_not_of(" \n\t") != std::string_view::npos) names.push_back(name_in(parameter));
            from = i + 1;
        }
        if (ends) break;
        if (c == '(' || c == '<' || c == '{') ++depth;
        if (c == ')' || c == '>' || c == '}') --depth;
    }
    return names;
}

/// Where a class begins that is called as the last part of this name is; 0 if none is.
std::size_t class_place(std::string_view code, std::string_view scope)
{
    const std::size_t last = scope.rfind("::");
    const std::string_view name = last == std::string_view::npos ? scope : scope.substr(last + 2);
    for (const char* const keyword : {"class ", "struct "}) {
        const std::string head = keyword + std::string(name);
        for (std::size_t place = code.find(head); place != std::string_view::npos; place = code.find(head, place + 1)) {
            const std::size_t next = code.find_first_not_of(" \n", place + head.size());
            const bool is_defined = next != std::string_view::npos &&
                                    (code[next] == '{' || code[next] == ':' || code.substr(next).starts_with("final"));
            if (is_defined && !is_letter(code[place + head.size()])) return place;
        }
    }
    return 0;
}

}

std::vector<std::string> parameter_names(std::string_view header, std::string_view function)
{
    const std::size_t last = function.rfind("::");
    const std::string_view name = last == std::string_view::npos ? function : function.substr(last + 2);
    const std::string code = without_comments(header);
    // Several classes may have a function of this name.
    const std::size_t first = last == std::string_view::npos ? 0 : class_place(code, function.substr(0, last));
    for (std::size_t place = code.find(name, first); place != std::string::npos; place = code.find(name, place + 1)) {
        const std::size_t end = place + name.size();
        const bool whole = (place == 0 || !is_letter(code[place - 1])) && end < code.size() && code[end] == '(';
        if (whole) return names_in(std::string_view(code).substr(end + 1));
    }
    return {};
}

std::string_view owner_of(std::string_view words)
{
    const std::size_t end = words.find_last_of(".[");
    return end == std::string_view::npos ? std::string_view() : words.substr(0, end);
}

std::optional<ArgumentPlace> argument_place(std::string_view place)
{
    const std::size_t digit = place.starts_with("the ") ? place.rfind(' ') + 1 : 0;
    ArgumentPlace found{place.substr(0, digit), 0, {}};
    const char* const end = place.data() + place.size();
    const auto [behind, error] = std::from_chars(place.data() + digit, end, found.argument);
    if (error != std::errc()) return std::nullopt;
    found.after = std::string_view(behind, end);
    return found;
}

std::string in_words(std::string_view place, const std::vector<std::string>& parameters)
{
    constexpr std::array ordinals = {"first", "second", "third", "fourth", "fifth", "sixth"};
    const std::optional<ArgumentPlace> found = argument_place(place);
    if (!found) return std::string(place);
    const std::size_t number = found->argument;
    const std::string before(found->before);
    const std::string after(found->after);
    if (number < parameters.size() && !parameters[number].empty()) return before + parameters[number] + after;
    return before + "the " + (number < ordinals.size() ? ordinals[number] : "last") + " argument" +
           (after.empty() ? "" : "'s ") + (after.starts_with('.') ? after.substr(1) : after);
}

}
