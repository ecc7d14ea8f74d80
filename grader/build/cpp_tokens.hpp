#pragma once

#include <string>
#include <string_view>

namespace umbral::grader {

/// A token of preprocessed C++.
struct CppToken {
    /// Broken: a string or a character that is not closed, or a character of many letters, which no compiler takes.
    enum class Kind { end, name, string, number, other, directive, broken };
    Kind kind = Kind::end;
    std::string_view text;  ///< as written, but of a digraph what it stands for; of a directive the whole line
    /// Of a string the characters between the quotes, as written; a raw string's characters, too.
    [[nodiscard]] std::string_view content() const;
};

/// Cuts preprocessed C++ into tokens, one after the other. Never fails: what is no token is a token of one character. A
/// string or a character that is not closed ends with its line, a raw string with the text.
class CppTokens {
public:
    explicit CppTokens(std::string_view text) : text_(text) {}

    /// The next token; Kind::end, as often as one likes, behind the last.
    CppToken next();

    /// The file and the line of the last token, as line markers tell: "sphere.cpp:12". A hint for people: markers may
    /// lie.
    [[nodiscard]] std::string place() const;

private:
    CppToken take(CppToken::Kind kind, std::size_t size);
    CppToken take_other();
    CppToken take_directive();
    CppToken take_string(std::size_t prefix);
    CppToken take_raw_string(std::size_t prefix);
    void follow_marker(std::string_view line);
    [[nodiscard]] char at(std::size_t offset) const { return offset < text_.size() ? text_[offset] : '\0'; }

    std::string_view text_;
    bool at_line_start_ = true;
    std::size_t line_ = 1;
    std::string_view file_;
};

}
