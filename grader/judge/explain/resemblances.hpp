#pragma once

#include "judge/explain/explain.hpp"
#include "judge/rows/rows.hpp"

namespace umbral::grader {

// What several judges answer when they are asked whether a student's result is wrong as a mistake's is. Both results
// can be judged.

/// Rows, cells: within the check's tolerance of the mistake's value for at least 95 % of those where either deviates.
[[nodiscard]] Resemblance same_rows(const FailingCheck& failing, const Tensor& mistake);
/// Pictures, by the rule of their judge.
[[nodiscard]] Resemblance same_picture(const FailingCheck& failing, const Tensor& mistake);

/// A few numbers that agree, each of which says something; one alone if everything is lost, as with code that does
/// nothing.
[[nodiscard]] Resemblance alike(std::size_t agreeing, bool nothing_at_all);

/// The tensor with finite values, and with the columns of `expected` where it has no rows at all.
[[nodiscard]] Tensor comparable_table(const Tensor& tensor, const Tensor& expected);

/// How single rows of this check are compared.
[[nodiscard]] const RowKind& rows_of(const Check& check);
/// Which of the rows count.
[[nodiscard]] std::vector<bool> counted(const std::vector<RowState>& states);
/// Pixels that differ by more than rounding can.
[[nodiscard]] std::vector<bool> different_pixels(const Check& check, const Tensor& a, const Tensor& b);

}
