#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "question/answer_relations.hpp"

namespace umbral::grader {

/// Wrong numbers that lie on the same side of a number of the question as the right ones, but some constant times as
/// far from it, or as far on the other side: what should be moved, turned or mixed was so too much, too little, or the
/// wrong way. `columns` are the wrong numbers of a row, each with what it is called; none where a row is one number,
/// which is set beside any number of the question. Columns are set beside the numbers that are called so in one
/// argument: `low.y` and `high.y` beside `box.low.y` and `box.high.y`.
///
/// Returns "2 times as far from box as the right one", or nothing if no such words hold for all of them, or if too
/// few differ to say so.
[[nodiscard]] std::optional<std::string> distance_relation(const std::vector<WrongNumbers>& columns,
                                                           const std::vector<std::string>& names,
                                                           const std::vector<Fact>& facts);

/// "the right one plus 2 times strips.size()": how each wrong number differs from the right one, where that is the same
/// multiple of a number of the question. Nothing as above.
[[nodiscard]] std::optional<std::string> difference_relation(const WrongNumbers& numbers,
                                                             const std::vector<Fact>& facts);

}
