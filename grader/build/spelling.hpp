#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

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
