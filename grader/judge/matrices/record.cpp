#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "judge/evidence/kinds.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/explain/transforms.hpp"
#include "judge/judge_record.hpp"
#include "judge/rows/rows.hpp"

namespace umbral::grader {
namespace {

std::size_t side_of(std::size_t components) { return components == 9 ? 3 : 4; }

double largest_of(std::span<const double> values)
{
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

double largest_in_column(std::span<const double> matrix, std::size_t index)
{
    const std::size_t side = side_of(matrix.size());
    return largest_of(matrix.subspan(index / side * side, side));
}

Scale column_scale(std::span<const double> expected, std::size_t index)
{
    const double column = largest_in_column(expected, index);
    const double size = column > 0 ? column : largest_of(expected);
    return {float_ulp(size), size};
}

std::string entry_text(std::size_t matrix, std::size_t components, std::size_t index)
{
    return "matrix " + std::to_string(matrix) + ", entry " + matrix_entry(components, index);
}

// What is next to nothing beside its column is what rounding left of 0 (a cosine of 90 degrees), unless it is whole, or
// more digits must tell two values apart.
std::string entry_number(std::span<const double> matrix, std::size_t index, int digits)
{
    constexpr double nothing = 1e-9;
    const double entry = matrix[index];
    const bool shows_nothing = digits <= usual_digits && entry != std::trunc(entry) &&
                               std::abs(entry) < nothing * largest_in_column(matrix, index);
    return shows_nothing ? "0" : number_text(entry, digits);
}

// The entry, then the whole matrix by rows: "5 in [1 0 0 5; 0 1 0 0; 0 0 1 0; 0 0 0 1]".
std::string matrix_text(const TensorView& view, std::size_t row, std::size_t index, int digits)
{
    if (!view.present(row)) return "nothing";
    const auto entries = view.cell(row);
    const std::size_t side = side_of(entries.size());
    std::string text = entry_number(entries, index, digits) + " in [";
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t j = 0; j < side; ++j)
            text += (j > 0 ? " " : i > 0 ? "; " : "") + entry_number(entries, j * side + i, digits);
    return text + "]";
}

constexpr RowKind matrices{"matrix", "matrices", column_scale, entry_text, matrix_text, entry_number};

}

const RowKind& matrix_rows() { return matrices; }

std::string matrix_entry(std::size_t components, std::size_t index)
{
    const std::size_t side = side_of(components);
    return "(row " + std::to_string(index % side) + ", column " + std::to_string(index / side) + ")";
}

namespace {

Judgement judge_matrices(const Question& question)
{
    const std::uint32_t components = question.expected.components;
    if (components != 9 && components != 16)
        throw std::invalid_argument("check '" + question.check.name +
                                    "': matrices have 9 or 16 components, the expected ones have " +
                                    std::to_string(components));
    return judge_rows(question.check, question.student, question.expected, question.margin, matrices);
}

}

/// Rows of 9 or 16 components, column-major. Relative bounds and ulps count against the largest entry of the expected
/// column (of the whole matrix where that column is zero): a translation of a million does not excuse the rotation
/// beside it, and an entry that is zero by cancellation may keep the rounding of its neighbours.
extern constinit const JudgeRecord matrices_judge;
constinit const JudgeRecord matrices_judge{
    .name = "matrices",
    .place = 1,
    .compares = "matrices",
    .needs_tolerance = true,
    .pairs = true,
    .judge = judge_matrices,
    .resemblance = same_rows,
    .rows = matrix_rows,
    .transforms = matrix_transforms,
    .evidence = rows_evidence,
    .relation = {.possible = true, .scales = true},
};

}
