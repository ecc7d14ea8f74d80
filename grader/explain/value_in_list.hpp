#pragma once

#include <cstddef>
#include <optional>

#include "model/scorecard.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// Of two lists whose rows begin with `keys` numbers that only say where in the list they stand, as a polygon's corners
/// do: the first expected row that is nowhere among the others, whatever its place, beside the nearest of those that
/// are expected nowhere; or one of these where none is lacking. The cell is a row of `expected`. Nothing if keys say
/// more than places, or if both lists hold the same rows.
[[nodiscard]] std::optional<Difference> first_value_apart(const Tensor& yours, const Tensor& expected,
                                                          std::size_t keys);

/// Two lists that a question led to, as "(4, 6), (8, 6)", without the keys; with no cell. Nothing if one has no rows or
/// more than a few, or if its keys are others than the question, the row's place and 0.
[[nodiscard]] std::optional<Difference> short_lists(const Tensor& yours, const Tensor& expected, std::size_t keys);

}
