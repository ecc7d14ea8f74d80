#pragma once

#include <cstddef>
#include <optional>
#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// Absolute and relative: sums of floats in another order differ by less, and other answers by more.
inline constexpr double answer_tolerance = 1e-3;

/// What an answer to counted work amounted to (record_cost), where that is not what is expected.
struct WrongAnswer {
    struct Number {
        std::size_t place;  ///< among the answer's numbers
        double yours;
        double expected;
    };
    std::size_t row;                 ///< of the table of costs
    std::optional<Number> number{};  ///< the first that differs; nothing if the row is missing, or too many
};

/// The first wrong answer; nothing if all are right, or if none are expected. Rows that are missing are wrong, and so
/// are any that are too many.
[[nodiscard]] std::optional<WrongAnswer> first_wrong_answer(const Tensor* student, const Tensor* expected);

}
