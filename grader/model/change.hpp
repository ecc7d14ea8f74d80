#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// A solution written as what it changes in another one: what a mistake is, in the lines that are wrong.
///
/// The file begins with "key: value" lines. Then come steps, each a line "---", the text that goes, a line "+++" and
/// the text that comes instead. The text that goes must occur exactly once.
struct Change {
    struct Step {
        std::string before;
        std::string after;
    };
    std::map<std::string, std::string> header;
    std::vector<Step> steps;
};

/// Keys that a solution's first lines may have.
inline constexpr std::string_view solution_keys[] = {"mistake", "alternative", "credit", "hint", "verdict",
                                                     "rubric",  "from",        "file",   "knob"};

/// The lines "key: value" that a text begins with, with or without "//" before them; a line without a key goes on with
/// the value before it. Ends at the first line of code ("---" is one), or where comments were and are no more.
[[nodiscard]] std::map<std::string, std::string> solution_header(std::string_view text);

/// Throws std::runtime_error that says, beginning with `where`, which line is not as it must be.
[[nodiscard]] Change parse_change(const std::string& text, const std::string& where);

/// `base` with every step made. Throws std::runtime_error that names `where` and the text that was not found, or found
/// more than once.
[[nodiscard]] std::string apply_change(const Change& change, std::string base, const std::string& where);

}
