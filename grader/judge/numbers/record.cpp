#include <algorithm>
#include <cmath>

#include "judge/evidence/kinds.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/explain/transforms.hpp"
#include "judge/judge_record.hpp"
#include "judge/rows/columns.hpp"
#include "judge/rows/rows.hpp"

namespace umbral::grader {
namespace {

Scale component_scale(std::span<const double> expected, std::size_t index)
{
    double largest = 0;
    for (const double value : expected) largest = std::max(largest, std::abs(value));
    return {float_ulp(expected[index]), largest};
}

constexpr RowKind numbers{
    "row",
    "rows",
    component_scale,
    [](std::size_t row, std::size_t, std::size_t) { return "row " + std::to_string(row); },
    [](const TensorView& view, std::size_t row, std::size_t, int digits) { return cell_text(view, row, digits); },
    [](std::span<const double> row, std::size_t index, int digits) { return number_text(row[index], digits); }};

}

const RowKind& number_rows() { return numbers; }

/// Rows of numbers, each within the check's tolerance.
extern constinit const JudgeRecord numbers_judge;
constinit const JudgeRecord numbers_judge{
    .name = "numbers",
    .place = 1,
    .compares = "numbers row by row",
    .needs_tolerance = true,
    .pairs = true,
    .judge =
        [](const Question& q) {
            return judge_rows(q.check, q.student, q.expected, q.margin, numbers,
                              column_names(text_of(q.names), q.expected.components, q.check.value));
        },
    .resemblance = same_rows,
    .rows = number_rows,
    .transforms = number_transforms,
    .evidence = rows_evidence,
    .relation = {.possible = true, .scales = true},
};

}
