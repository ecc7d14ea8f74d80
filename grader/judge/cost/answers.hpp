#pragma once

#include <cstddef>
#include <optional>
#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// Absolute and relative: sums of floats in another order differ by less, and other answers by more.
inline constexpr double answer_tolerance = 1e-3;

/// The first row in which what the answers to counted work amounted to (record_cost) is not what is expected; nothing
/// if all are right, or if none are expected. Rows that are missing are wrong, and so are any that are too many.
[[nodiscard]] std::optional<std::size_t> first_wrong_answer(const Tensor* student, const Tensor* expected);

}
