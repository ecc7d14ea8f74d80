#pragma once

#include <span>
#include <string>
#include <vector>

#include "judge/judge.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rows/tolerance.hpp"

namespace umbral::grader {

/// What distinguishes the kinds of tables that are judged row by row.
struct RowKind {
    const char* one;   ///< "row"
    const char* many;  ///< "rows"
    /// What component `index` of an expected row is measured against.
    Scale (*scale)(std::span<const double> expected, std::size_t index);
    /// Where component `index` of a row is, and how the row is shown.
    std::string (*where)(std::size_t row, std::size_t components, std::size_t index);
    std::string (*show)(const TensorView& view, std::size_t row, std::size_t index, int digits);
    /// How one number of a row is shown.
    std::string (*show_number)(std::span<const double> row, std::size_t index, int digits);
};

/// Two tables that are compared row by row. `columns` are names of the rows' numbers (columns.hpp), or nothing.
struct RowPairs {
    const Check& check;
    const TensorView& student;
    const TensorView& expected;
    const RowKind& kind;
    const std::vector<std::string>& columns;
};

/// Which of a row's numbers are wrong, by name: "y", "GL_LINE_WIDTH and 2 others of it". Empty where they have no
/// names, or where several are wrong of a row that is read as one, of up to four.
[[nodiscard]] std::string wrong_columns(const RowPairs& pairs, std::size_t row);

/// What both sides have in a row, in as many digits as tell them apart, and where: "row 3, y". Of a row of more than
/// four numbers that have names, the first wrong one alone.
[[nodiscard]] Difference row_difference(const RowPairs& pairs, std::size_t row);

enum class RowState : std::uint8_t { left_out, right, wrong };

/// What became of each row, without pairing their results; `expected` must be finite where it counts.
[[nodiscard]] std::vector<RowState> row_states(const Check& check, const Tensor& student, const Tensor& expected,
                                               const Tensor* margin, const RowKind& kind);

/// The kinds of rows of the judges numbers and matrices.
[[nodiscard]] const RowKind& number_rows();
[[nodiscard]] const RowKind& matrix_rows();

/// "(row 1, column 3)": an entry of a matrix of 9 or 16 numbers, column after column as GLM has them.
[[nodiscard]] std::string matrix_entry(std::size_t components, std::size_t index);

/// Judges row by row: a component is right if any given bound holds, a row if all its components are and its presence
/// agrees.
///
/// Rows whose margin is under the band do not count; with check.pairs, rows 2k and 2k + 1 count only together, and a
/// pair is left out if either row is. The error leaves out components that are right by another bound than the one that
/// gives the unit (an ulp of an expected 0 says nothing). Throws std::invalid_argument on what only the grader's side
/// can have caused.
[[nodiscard]] Judgement judge_rows(const Check& check, const Tensor& student, const Tensor& expected,
                                   const Tensor* margin, const RowKind& kind,
                                   const std::vector<std::string>& columns = {});

}
