#include <algorithm>
#include <cmath>

#include "judge/rows.hpp"
#include "judge/rules.hpp"

namespace umbral::grader {
namespace {

Scale component_scale(std::span<const double> expected, std::size_t index)
{
    double largest = 0;
    for (const double value : expected) largest = std::max(largest, std::abs(value));
    return {float_ulp(expected[index]), largest};
}

constexpr RowKind numbers{"row", "rows", component_scale, [](std::size_t row, std::size_t, std::size_t) { return "row " + std::to_string(row); },
                          [](const TensorView& view, std::size_t row, std::size_t) { return cell_text(view, row); }};

}

const RowKind& number_rows() { return numbers; }

Judgement judge_numbers(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin)
{
    return judge_rows(check, student, expected, margin, numbers);
}

}
