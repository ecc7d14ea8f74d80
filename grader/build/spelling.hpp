#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// A letter, a digit or an underscore: what may stand in a name.
[[nodiscard]] constexpr bool is_word(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// "intersect" of "umbral::raytracing::intersect".
[[nodiscard]] constexpr std::string_view last_name(std::string_view qualified)
{
    const std::size_t colon = qualified.rfind("::");
    return colon == std::string_view::npos ? qualified : qualified.substr(colon + 2);
}

/// A demangled signature as a student would write it: glm::vec3 for glm::vec<3, float, (glm::qualifier)0>, and so on.
[[nodiscard]] std::string as_written(std::string signature);

/// The text of a shader or a C++ file without its comments, each replaced by a space, and with lines that end in a
/// backslash joined. Linear in the size of the text, whatever it holds.
[[nodiscard]] std::string without_comments(std::string_view text);

/// Does `text` hold `word`, with no letter, digit or underscore beside it?
[[nodiscard]] bool holds_word(std::string_view text, std::string_view word);

/// Is `text` what `pattern` describes? A `*` stands for any characters, also none; all else for itself.
[[nodiscard]] bool matches_pattern(std::string_view text, std::string_view pattern);

}
