#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "question/reactions.hpp"

namespace umbral::grader {

/// In which way wrong answers miss the right ones.
enum class ErrorKind : std::uint8_t {
    factor,      ///< how many times the right one each is
    difference,  ///< what each is more than the right one
};

/// What the error of wrong answers depends on, in some of their numbers, though they depend on more.
struct ErrorDependence {
    std::vector<std::size_t> components{};
    ErrorKind kind = ErrorKind::factor;
    MovedPlace place{};

    friend bool operator==(const ErrorDependence&, const ErrorDependence&) = default;
};

/// Numbers whose error changes with a single place, where right ones change with others too: in a product or a sum one
/// term is wrong, and that is the place of which it is made. Nothing of errors that are the same everywhere, which
/// answer_patterns tells.
[[nodiscard]] std::vector<ErrorDependence> error_dependences(const std::vector<MoveReactions>& moves);

}
