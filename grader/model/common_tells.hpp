#pragma once

#include <cstdint>
#include <string_view>

namespace umbral::grader {

/// What it is that all wrong answers share, where whoever shows it chooses by that.
enum class CommonTells : std::uint8_t {
    other,      ///< anything else
    constant,   ///< that they are all the same
    place,      ///< only which of their numbers are wrong
    nearly,     ///< that they are nearly right
    mostly,     ///< that most of them are nearly right
    side,       ///< on which side of the right ones they lie
    multiple,   ///< how many times the right ones they are, a number that has no name
    opposite,   ///< that they are the right ones with the opposite sign
    one_sided,  ///< where all of them lie, but right ones, too
};

/// Where the wrong answers lie, and not what they are: said only where nothing else is known.
[[nodiscard]] constexpr bool is_vague(CommonTells tells)
{
    return tells == CommonTells::place || tells == CommonTells::nearly || tells == CommonTells::mostly ||
           tells == CommonTells::side || tells == CommonTells::one_sided;
}

/// The name in JSON: "side". `other` has none there: the member is left out.
[[nodiscard]] std::string_view to_string(CommonTells tells);
/// The one of that JSON name. Throws std::invalid_argument for any other text.
[[nodiscard]] CommonTells common_tells_from(std::string_view name);

}
