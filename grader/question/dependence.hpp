#pragma once

#include <cstddef>
#include <vector>

#include "question/reactions.hpp"

namespace umbral::grader {

/// What wrong answers depend on in place of what they should, in some of their numbers.
struct Dependence {
    std::vector<std::size_t> components{};
    std::vector<MovedPlace> wrongly{};  ///< that they change with, and the right ones do not
    std::vector<MovedPlace> lacking{};  ///< that the right ones change with, and they do not

    friend bool operator==(const Dependence&, const Dependence&) = default;
};

/// Of wrong answers to which most moves give the right ones nothing is said: these are wrong in one place only, as
/// where two numbers are equal.
///
/// Numbers of wrong answers of which most change with an argument, in each set of inputs, that no right one changes
/// with there, or the reverse. Said of few places only: an answer that changes with nothing is constant, and one that
/// changes with everything is of another kind.
[[nodiscard]] std::vector<Dependence> dependences(const std::vector<MoveReactions>& moves);

}
