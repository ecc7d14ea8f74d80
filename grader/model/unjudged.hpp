#pragma once

#include <cstdint>
#include <string_view>

namespace umbral::grader {

/// What kept all of a check from being judged.
enum class Unjudged : std::uint8_t {
    no,             ///< nothing did
    unwritten,      ///< it asks a function that is not written yet
    stopped,        ///< its case crashed, or was stopped
    not_run,        ///< its case was not run, since too many before took too long
    wrong_answers,  ///< it counts work, which led to wrong answers
};

/// The name in JSON: "not_run". `no` has none there: the member is left out.
[[nodiscard]] std::string_view to_string(Unjudged unjudged);
/// The same in words for people: "not run".
[[nodiscard]] std::string_view in_words(Unjudged unjudged);
/// The one of that JSON name. Throws std::invalid_argument for any other text.
[[nodiscard]] Unjudged unjudged_from(std::string_view name);

}
