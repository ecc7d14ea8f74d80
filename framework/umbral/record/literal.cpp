#include "umbral/record/literal.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace umbral::literal {
namespace {

template <class Number>
std::string of_real(Number value, std::string_view suffix)
{
    if (std::isnan(value)) return "NAN";
    if (std::isinf(value)) return value < 0 ? "-INFINITY" : "INFINITY";
    std::array<char, 64> room{};
    const auto end = std::to_chars(room.data(), room.data() + room.size(), value).ptr;
    std::string text(room.data(), end);
    const bool whole = text.find_first_not_of("-0123456789") == std::string::npos;
    // A whole number needs no suffix, unless it is 0 with a sign, or too large for an int.
    if (whole && !(value == 0 && std::signbit(value)) && std::abs(value) < Number{1'000'000'000}) return text;
    if (whole) text += ".0";
    return text.append(suffix);
}

void replace_all(std::string& text, std::string_view from, std::string_view to)
{
    for (std::size_t place = text.find(from); place != std::string::npos; place = text.find(from, place + to.size()))
        text.replace(place, from.size(), to);
}

/// Lines of plain letters, short enough to be read: a shader, a script, a file made by hand.
bool is_written_in_lines(std::string_view text)
{
    constexpr std::size_t widest = 200;
    std::size_t width = 0;
    for (const char letter : text) {
        width = letter == '\n' ? 0 : width + 1;
        if (width > widest || (letter != '\n' && (letter < 0x20 || letter >= 0x7F))) return false;
    }
    return text.find('\n') < text.size() - 1 && text.find(")\"") == std::string_view::npos;
}

std::string raw_text(std::string_view text, std::size_t most_lines)
{
    std::size_t end = 0;
    for (std::size_t line = 0; line < most_lines && end < text.size(); ++line)
        end = std::min(text.find('\n', end), text.size() - 1) + 1;
    std::string result = "R\"(" + std::string(text.substr(0, end)) + ")\"";
    if (end < text.size()) {
        const auto more = std::count(text.begin() + static_cast<std::ptrdiff_t>(end), text.end(), '\n') +
                          (text.ends_with('\n') ? 0 : 1);
        result += " … " + std::to_string(more) + " more lines";
    }
    return result;
}

/// What types are called by those who use them.
constexpr std::pair<std::string_view, std::string_view> usual_names[] = {
    {", glm::packed_highp", ""},
    {"glm::vec<2, float>", "glm::vec2"},
    {"glm::vec<3, float>", "glm::vec3"},
    {"glm::vec<4, float>", "glm::vec4"},
    {"glm::vec<2, double>", "glm::dvec2"},
    {"glm::vec<3, double>", "glm::dvec3"},
    {"glm::vec<4, double>", "glm::dvec4"},
    {"glm::vec<2, int>", "glm::ivec2"},
    {"glm::vec<3, int>", "glm::ivec3"},
    {"glm::vec<4, int>", "glm::ivec4"},
    {"glm::vec<2, unsigned int>", "glm::uvec2"},
    {"glm::vec<3, unsigned int>", "glm::uvec3"},
    {"glm::vec<4, unsigned int>", "glm::uvec4"},
    {"glm::vec<4, unsigned char>", "glm::u8vec4"},
    {"glm::mat<2, 2, float>", "glm::mat2"},
    {"glm::mat<3, 3, float>", "glm::mat3"},
    {"glm::mat<4, 4, float>", "glm::mat4"},
    {"glm::mat<4, 4, double>", "glm::dmat4"},
    {"std::__cxx11::basic_string<char>", "std::string"},
    {"std::basic_string_view<char>", "std::string_view"},
    {", 18446744073709551615", ""},
    {"long unsigned int", "std::uint64_t"},
    {"unsigned int", "std::uint32_t"},
    {"unsigned char", "std::uint8_t"},
    {" >", ">"},
};

}

std::string of(float value) { return of_real(value, "F"); }
std::string of(double value) { return of_real(value, ""); }

std::string of_integer(std::int64_t value) { return std::to_string(value); }
std::string of_integer(std::uint64_t value)
{
    return std::to_string(value) + (value > static_cast<std::uint64_t>(std::numeric_limits<int>::max()) ? "U" : "");
}

std::string of_text(std::string_view text, const Style& style)
{
    if (is_written_in_lines(text)) return raw_text(text, style.most_lines);
    constexpr std::string_view digits = "01234567";
    std::string result = "\"";
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i >= style.most_letters) return result + "\" … " + std::to_string(text.size() - i) + " more letters";
        const auto letter = static_cast<unsigned char>(text[i]);
        if (letter == '"' || letter == '\\')
            result += {'\\', static_cast<char>(letter)};
        else if (letter == '\n')
            result += "\\n";
        else if (letter == '\r')
            result += "\\r";
        else if (letter == '\t')
            result += "\\t";
        else if (letter < 0x20 || letter >= 0x7F)  // three octal digits end by themselves, whatever follows
            result += {'\\', digits[letter >> 6U], digits[letter >> 3U & 7U], digits[letter & 7U]};
        else
            result += static_cast<char>(letter);
    }
    return result + "\"";
}

std::string short_type(std::string_view type)
{
    std::string text(type);
    for (const auto& [from, to] : usual_names) replace_all(text, from, to);
    // umbral:: and the topic's namespace, wherever a name begins with them.
    for (std::size_t place = text.find("umbral::"); place != std::string::npos; place = text.find("umbral::", place)) {
        text.erase(place, std::string_view("umbral::").size());
        const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789", place);
        if (end != std::string::npos && text.compare(end, 2, "::") == 0) text.erase(place, end + 2 - place);
    }
    if (text.starts_with("std::vector<")) {
        const std::size_t allocator = text.find(", std::allocator<");
        if (allocator != std::string::npos) text = text.substr(0, allocator) + ">";
    }
    return text;
}

std::string object_name(std::string_view type)
{
    std::string name(reflect::last_name(short_type(type).substr(0, short_type(type).find('<'))));
    while (!name.empty() && std::isalnum(static_cast<unsigned char>(name.back())) == 0) name.pop_back();
    std::string words;
    for (const char letter : name) {
        const bool capital = std::isupper(static_cast<unsigned char>(letter)) != 0;
        if (capital && !words.empty()) words += '_';
        words += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    return words.empty() ? "value" : words;
}

}
