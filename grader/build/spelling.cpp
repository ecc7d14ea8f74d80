#include "build/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace umbral::grader {
namespace {

void replace_all(std::string& text, std::string_view old, std::string_view with)
{
    for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + with.size()))
        text.replace(at, old.size(), with);
}

using Spelling = std::pair<std::string, std::string>;

std::vector<Spelling> spellings()
{
    std::vector<Spelling> list;
    for (const auto& [type, letter] : {std::pair("float", ""), std::pair("double", "d"), std::pair("int", "i"),
                                       std::pair("unsigned int", "u"), std::pair("bool", "b")})
        for (int size = 1; size <= 4; ++size) {
            list.emplace_back(fmt::format("glm::vec<{}, {}, (glm::qualifier)0>", size, type),
                              fmt::format("glm::{}vec{}", letter, size));
            list.emplace_back(fmt::format("glm::mat<{0}, {0}, {1}, (glm::qualifier)0>", size, type),
                              fmt::format("glm::{}mat{}", letter, size));
        }
    for (const char* space : {"", " "})
        list.emplace_back(
            fmt::format("std::__cxx11::basic_string<char, std::char_traits<char>, std::allocator<char>{}>", space),
            "std::string");
    return list;
}

/// Of the end of a line that the text begins with, in any of the ways that shader compilers know; 0 if it does not.
std::size_t newline_size(std::string_view text)
{
    if (text.starts_with("\r\n") || text.starts_with("\n\r")) return 2;
    return text.starts_with('\n') || text.starts_with('\r') ? 1 : 0;
}

}

std::string as_written(std::string signature)
{
    static const std::vector<Spelling> list = spellings();
    for (const auto& [compilers, students] : list) replace_all(signature, compilers, students);
    return signature;
}

std::string without_comments(std::string_view text)
{
    std::string joined;
    joined.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t newline = text[i] == '\\' ? newline_size(text.substr(i + 1)) : 0;
        if (newline == 0) joined += text[i];
        i += newline;
    }
    std::string bare;
    bare.reserve(joined.size());
    for (std::size_t i = 0; i < joined.size();) {
        const std::string_view here = std::string_view(joined).substr(i, 2);
        if (here == "//") {
            i = std::min(joined.find_first_of("\r\n", i), joined.size());
            bare += ' ';
        } else if (here == "/*") {
            const std::size_t end = joined.find("*/", i + 2);
            i = end == std::string::npos ? joined.size() : end + 2;
            bare += ' ';
        } else {
            bare += joined[i++];
        }
    }
    return bare;
}

bool holds_word(std::string_view text, std::string_view word)
{
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_word(text[at - 1])) && (end == text.size() || !is_word(text[end]))) return true;
    }
    return false;
}

bool matches_pattern(std::string_view text, std::string_view pattern)
{
    // The last star seen and where its text began: going back to it is all that is ever needed.
    std::size_t t = 0;
    std::size_t p = 0;
    std::size_t star = std::string_view::npos;
    std::size_t star_text = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            star_text = t;
        } else if (p < pattern.size() && pattern[p] == text[t]) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++star_text;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}
