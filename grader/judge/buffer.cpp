#include <fmt/format.h>

#include <cmath>
#include <map>

#include "judge/rules.hpp"
#include "judge/tensor_view.hpp"
#include "judge/tolerance.hpp"

namespace umbral::grader {
namespace {

// The cell whose value is most frequent on the border; of equally frequent ones, the one seen first.
std::size_t background_cell(const Tensor& tensor, const TensorView& view)
{
    std::map<std::pair<bool, std::vector<double>>, std::size_t> counts;
    std::size_t best = 0;
    std::size_t most = 0;
    for (std::size_t y = 0; y < tensor.rows; ++y)
        for (std::size_t x = 0; x < tensor.columns; ++x) {
            if (y > 0 && y + 1 < tensor.rows && x > 0 && x + 1 < tensor.columns) continue;
            const std::size_t cell = y * tensor.columns + x;
            const auto values = view.cell(cell);
            // NaN has no order; an expected one is nobody's background.
            bool number = true;
            for (const double value : values) number = number && !std::isnan(value);
            if (!number) continue;
            const std::size_t count = ++counts[{view.present(cell), {values.begin(), values.end()}}];
            if (count > most) most = count, best = cell;
        }
    return best;
}

struct CellMatch {
    bool equal = true;
    bool comparable = true;
    double error = 0;
};

// Infinity equals itself here: it is what many clear a depth buffer to. NaN equals nothing.
CellMatch match(const Tolerance& tolerance, const TensorView& a, std::size_t cell_a, const TensorView& b, std::size_t cell_b)
{
    if (!a.present(cell_a) || !b.present(cell_b)) return {a.present(cell_a) == b.present(cell_b), false, 0};
    CellMatch result;
    for (std::size_t i = 0; i < b.components(); ++i) {
        const double yours = a.cell(cell_a)[i];
        const double expected = b.cell(cell_b)[i];
        if (yours == expected) continue;
        const Deviation found = deviation(tolerance, yours, expected, {float_ulp(expected), std::abs(expected)});
        result.equal = result.equal && found.right && std::isfinite(expected);
        if (!found.right || found.within) result.error = std::max(result.error, found.error);
    }
    return result;
}

std::string where(const Tensor& tensor, std::size_t cell)
{
    return "pixel (" + std::to_string(cell % tensor.columns) + ", " + std::to_string(cell / tensor.columns) + ")";
}

}

Judgement judge_buffer(const Check& check, const Tensor& student_tensor, const Tensor& expected_tensor)
{
    const TensorView student(student_tensor);
    const TensorView expected(expected_tensor);
    const std::size_t background = background_cell(expected_tensor, expected);
    const bool measured = expected_tensor.element == Element::float32 || expected_tensor.element == Element::float64;

    std::size_t content = 0;
    std::size_t missing = 0;
    std::size_t extra = 0;
    std::size_t other = 0;
    double error = 0;
    std::optional<std::size_t> first;
    for (std::size_t cell = 0; cell < expected.cells(); ++cell) {
        const CellMatch found = match(check.tolerance, student, cell, expected, cell);
        const bool expected_background = match(check.tolerance, expected, cell, expected, background).equal;
        const bool student_background = match(check.tolerance, student, cell, expected, background).equal;
        if (expected_background && student_background && found.equal) continue;
        ++content;
        if (found.comparable) error = std::max(error, found.error);
        if (found.equal) continue;
        if (!first) first = cell;
        ++(expected_background ? extra : student_background ? missing : other);
    }

    Judgement result;
    const std::size_t wrong = missing + extra + other;
    result.right = content == 0 ? 1.0 : static_cast<double>(content - wrong) / static_cast<double>(content);
    // Names such as ids are equal or not: only measured values lie some distance apart.
    if (wrong == 0 || (measured && std::isfinite(error))) result.error = error;
    result.metrics = {{"cells", static_cast<double>(content)},
                      {"wrong", static_cast<double>(wrong)},
                      {"missing", static_cast<double>(missing)},
                      {"extra", static_cast<double>(extra)},
                      {"wrong_value", static_cast<double>(other)}};
    if (!first) return result;
    result.first_difference = Difference{where(expected_tensor, *first), cell_text(student, *first), cell_text(expected, *first)};
    result.message = fmt::format("{} of {} cells {} wrong ({} missing, {} extra, {} with another value); the first is {}: yours {}, expected {}", wrong,
                                 content, wrong == 1 ? "is" : "are", missing, extra, other, result.first_difference->where, result.first_difference->yours,
                                 result.first_difference->expected);
    return result;
}

}
