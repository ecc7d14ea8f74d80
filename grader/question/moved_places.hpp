#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "question/reactions.hpp"

namespace umbral::grader {

/// The place that a move changes: "0.size.x" of "0.size" and "moved .x".
[[nodiscard]] MovedPlace moved_place(const OtherQuestion& move);

/// Places in as few words as may be, a vector in place of three of its components, or of one beside its length; none
/// if there are more than `most`.
[[nodiscard]] std::vector<MovedPlace> joined_places(std::set<MovedPlace> places, std::size_t most);

}
