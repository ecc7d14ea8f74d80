#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// What the parameters of a function are called where a header declares it: {"ray", "sphere"}. Nothing if it declares
/// none of that name; an empty name where it gives none. Of overloads, the first.
[[nodiscard]] std::vector<std::string> parameter_names(std::string_view header, std::string_view function);

/// Of "frame.x" the "frame", of "corners[0]" the "corners": the struct or array that a number or a vector is a part of;
/// empty for what is a part of none.
[[nodiscard]] std::string_view owner_of(std::string_view words);

/// A place in a question's arguments: "the least number in 1.x" lies in the argument 1.
struct ArgumentPlace {
    std::string_view before;  ///< "the least number in "
    std::size_t argument = 0;
    std::string_view after;  ///< ".x"
};

/// Nothing of what lies in none.
[[nodiscard]] std::optional<ArgumentPlace> argument_place(std::string_view place);

/// A place in a question's arguments in the header's words: "ray.origin.x" for "0.origin.x", "the first argument" where
/// the header has no name for it.
[[nodiscard]] std::string in_words(std::string_view place, const std::vector<std::string>& parameters);

}
