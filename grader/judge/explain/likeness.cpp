#include "judge/explain/likeness.hpp"

#include <algorithm>
#include <cmath>

#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

/// Of 32 values noise correlates to a half with a probability of 0.002.
constexpr std::size_t least_values = 32;

double share(std::size_t part, std::size_t whole)
{
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

using Cells = std::vector<std::size_t>;

/// The values of one component in some cells, about their mean. Beyond a picture's range the check does not look.
std::vector<double> centred(const Check& check, const TensorView& view, bool bytes, const Cells& cells,
                            std::size_t component)
{
    std::vector<double> values;
    values.reserve(cells.size());
    const bool in_range = judge_of(check).look == Look::colours && !bytes;
    double mean = 0;
    for (const std::size_t cell : cells) {
        const double value = view.cell(cell)[component];
        values.push_back(in_range ? std::clamp(value, check.range_low, check.range_high) : value);
        mean += values.back() / static_cast<double>(cells.size());
    }
    for (double& value : values) value -= mean;
    return values;
}

/// Sums of products over all components; nothing is equal to what does not vary.
double correlation(const Check& check, const Tensor& student, const TensorView& yours, const TensorView& expected,
                   const Cells& cells)
{
    double of_yours = 0;
    double of_expected = 0;
    double of_both = 0;
    for (std::size_t c = 0; c < expected.components(); ++c) {
        const std::vector<double> a = centred(check, yours, student.element == Element::uint8, cells, c);
        const std::vector<double> b = centred(check, expected, student.element == Element::uint8, cells, c);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            of_yours += a[i] * a[i];
            of_expected += b[i] * b[i];
            of_both += a[i] * b[i];
        }
    }
    const double result = of_both / std::sqrt(of_yours) / std::sqrt(of_expected);
    // Not a number where a side does not vary, or overflows.
    return result > 0 ? std::min(result, 1.0) : 0.0;
}

Cells cells_with_values(const TensorView& view)
{
    Cells cells;
    for (std::size_t cell = 0; cell < view.cells(); ++cell)
        if (view.present(cell) && all_finite(view.cell(cell))) cells.push_back(cell);
    return cells;
}

bool varies(const TensorView& view, const Cells& cells)
{
    const auto differs = [&](std::size_t cell) {
        return !std::ranges::equal(view.cell(cell), view.cell(cells.front()));
    };
    return std::any_of(cells.begin(), cells.end(), differs);
}

}

std::optional<double> likeness(const Check& check, const Tensor& student, const Tensor& reference)
{
    if (const auto own = judge_of(check).likeness) return own(student, reference);
    const TensorView yours(student);
    const TensorView expected(reference);
    const Cells here = cells_with_values(yours);
    const Cells there = cells_with_values(expected);
    const bool by_value = varies(expected, there);
    // Where all values are equal, what has one can still tell: a mask.
    const bool by_presence = there.size() < expected.cells() && !there.empty();
    if (expected.cells() * expected.components() < least_values || (!by_value && !by_presence)) return std::nullopt;
    Cells both;
    std::ranges::set_intersection(here, there, std::back_inserter(both));
    const double common = share(both.size(), here.size() + there.size() - both.size());
    if (both.empty() || !by_value) return common;
    return common * correlation(check, student, yours, expected, both);
}

}
