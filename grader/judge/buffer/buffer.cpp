#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/buffer/buffer_classes.hpp"
#include "judge/buffer/rule.hpp"

namespace umbral::grader {
namespace {

void explain(const Check& check, const BufferCells& cells, const Tensor& expected, Judgement& result)
{
    const BufferKind kind = kind_of(expected, cells);
    const BufferClasses classes = classify(check, cells, kind);
    const BufferPattern pattern = find_pattern(cells, kind);
    result.metrics.insert({{"at_edge", static_cast<double>(classes.at_edge)},
                           {"neighbour_value", static_cast<double>(classes.neighbour_value)},
                           {"groups", static_cast<double>(classes.groups)},
                           {"largest_group", static_cast<double>(classes.largest_group)}});
    result.metrics.insert(pattern.metrics.begin(), pattern.metrics.end());

    const auto first = static_cast<std::size_t>(
        std::ranges::find_if(cells.states, [](CellState state) { return state > CellState::right; }) -
        cells.states.begin());
    const auto [yours, right] = telling_apart([&](int digits) {
        return std::pair(cell_text(cells.yours, first, digits), cell_text(cells.expected, first, digits));
    });
    result.first_difference = Difference{pixel_text(cells, first), yours, right, first};
    const std::size_t content = cells.states.size() - cells.count(CellState::background);
    result.message = fmt::format(
        "{} of {} {} {} wrong ({} missing, {} extra, {} with another value); {}; the first is {}: yours {}, expected "
        "{}",
        classes.wrong, content, cells_of(kind, check.value), classes.wrong == 1 ? "is" : "are",
        cells.count(CellState::missing), cells.count(CellState::extra), cells.count(CellState::other),
        in_words(classes, pattern), result.first_difference->where, result.first_difference->yours,
        result.first_difference->expected);
    result.sketch = buffer_sketch(cells, kind, first);
}

}

Judgement judge_buffer(const Check& check, const Tensor& student, const Tensor& expected, bool with_classes)
{
    const BufferCells cells = compare_cells(check, student, expected);
    const std::size_t content = cells.states.size() - cells.count(CellState::background);
    const std::size_t missing = cells.count(CellState::missing);
    const std::size_t extra = cells.count(CellState::extra);
    const std::size_t other = cells.count(CellState::other);
    const std::size_t wrong = missing + extra + other;
    const bool measured = is_real(expected.element);

    Judgement result;
    result.right = content == 0 ? 1.0 : static_cast<double>(content - wrong) / static_cast<double>(content);
    // Names such as ids are equal or not: only measured values lie some distance apart.
    if (wrong == 0 || (measured && std::isfinite(cells.error))) result.error = cells.error;
    result.metrics = {{"cells", static_cast<double>(content)},
                      {"wrong", static_cast<double>(wrong)},
                      {"missing", static_cast<double>(missing)},
                      {"extra", static_cast<double>(extra)},
                      {"wrong_value", static_cast<double>(other)}};
    if (with_classes && wrong > 0) explain(check, cells, expected, result);
    return result;
}

}
