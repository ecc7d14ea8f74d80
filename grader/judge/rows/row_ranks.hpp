#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "judge/rows/alignment.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {

/// The rows of two tables by their places in the order of all: equal rows have the same one.
struct RowRanks {
    std::vector<std::uint32_t> a;
    std::vector<std::uint32_t> b;
};

/// The ranks of the first `rows_of_a` rows of `a` and of all of `b`, by their numbers, the first one first. Nothing
/// where a number is not whole, or the rows differ in length.
[[nodiscard]] std::optional<RowRanks> ranks_of_whole_rows(const TensorView& a, std::size_t rows_of_a,
                                                          const TensorView& b);

/// align() where rows are the same that are equal. Of tables in order it takes one pass, and is always the best one.
[[nodiscard]] Alignment align(const RowRanks& ranks);

}
