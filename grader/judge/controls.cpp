#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <umbral/core/random.hpp>

#include "judge/fragments.hpp"
#include "judge/noise.hpp"
#include "judge/rules.hpp"
#include "judge/tensor_view.hpp"

namespace umbral::grader {
namespace {

using Row = std::vector<double>;

Tensor shaped(const Tensor& expected)
{
    Tensor tensor = expected;
    std::fill(tensor.bytes.begin(), tensor.bytes.end(), std::byte{0});
    std::fill(tensor.present.begin(), tensor.present.end(), std::uint8_t{1});
    return tensor;
}

Tensor filled(const Tensor& expected, const Row& row)
{
    std::vector<double> values(expected.count());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = row[i % row.size()];
    return with_values(shaped(expected), values);
}

Tensor all_absent(const Tensor& expected)
{
    Tensor tensor = shaped(expected);
    std::fill(tensor.present.begin(), tensor.present.end(), std::uint8_t{0});
    return tensor;
}

// Means, lows and highs of each component over the finite values of present cells.
struct Statistics {
    Row mean;
    Row low;
    Row high;
};

Statistics statistics_of(const TensorView& view)
{
    const std::size_t components = view.components();
    Statistics result{Row(components, 0), Row(components, std::numeric_limits<double>::infinity()), Row(components, -std::numeric_limits<double>::infinity())};
    std::vector<double> counts(components, 0);
    for (std::size_t cell = 0; cell < view.cells(); ++cell)
        for (std::size_t c = 0; c < components && view.present(cell); ++c) {
            const double value = view.cell(cell)[c];
            if (!std::isfinite(value)) continue;
            counts[c] += 1;
            result.mean[c] += (value - result.mean[c]) / counts[c];
            result.low[c] = std::min(result.low[c], value);
            result.high[c] = std::max(result.high[c], value);
        }
    for (std::size_t c = 0; c < components; ++c)
        if (counts[c] == 0) result.low[c] = result.high[c] = 0;
    return result;
}

// The most frequent present cell, of those that `among` admits; bytes decide what is equal.
template <class Among>
Row most_frequent(const TensorView& view, Among among)
{
    std::map<Row, std::size_t> counts;
    Row best(view.components(), 0);
    std::size_t most = 0;
    for (std::size_t cell = 0; cell < view.cells(); ++cell) {
        const auto values = view.cell(cell);
        if (!view.present(cell) || !among(cell) || std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) continue;
        Row row(values.begin(), values.end());
        if (const std::size_t count = ++counts[row]; count > most) most = count, best = std::move(row);
    }
    return best;
}

Tensor noise(const Tensor& expected, const Statistics& statistics, std::uint64_t seed)
{
    Random random(seed);
    std::vector<double> values(expected.count());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t c = i % expected.components;
        values[i] = statistics.low[c] + (statistics.high[c] - statistics.low[c]) * random.uniform_double();
    }
    Tensor tensor = shaped(expected);
    for (std::uint8_t& present : tensor.present) present = static_cast<std::uint8_t>(random.below(2));
    const std::size_t width = expected.components;
    for (std::size_t cell = 0; cell < tensor.present.size(); ++cell)
        if (tensor.present[cell] == 0) std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(cell * width), width, 0.0);
    return with_values(tensor, values);
}

Tensor without_rows(const Tensor& expected)
{
    Tensor tensor = expected;
    tensor.rows = 0;
    tensor.bytes.clear();
    tensor.present.clear();
    return tensor;
}

// A function that does nothing, whatever the size: one block.
Tensor at_once(const Tensor& expected)
{
    std::vector<double> values = to_doubles(expected);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (i % expected.components > 0) values[i] = 1;
    return with_values(expected, values);
}

// What knows the scale of the estimates only. The mean of one quantity is its answer: of a single one, nothing is left that knows nothing.
std::vector<std::pair<std::string, Tensor>> estimate_controls(const Tensor& expected, std::uint64_t seed)
{
    const std::size_t components = expected.components;
    const Statistics each = statistics_of(TensorView(expected));
    const double mean = std::accumulate(each.mean.begin(), each.mean.end(), 0.0) / static_cast<double>(components);
    const double low = *std::min_element(each.low.begin(), each.low.end());
    const double high = *std::max_element(each.high.begin(), each.high.end());
    const Statistics all{Row(components, mean), Row(components, low), Row(components, high)};
    std::vector<std::pair<std::string, Tensor>> result{{"zeros", filled(expected, Row(components, 0))}, {"ones", filled(expected, Row(components, 1))}};
    if (components == 1) return result;
    result.emplace_back("mean of all", filled(expected, all.mean));
    result.emplace_back("noise", noise(expected, all, seed));
    return result;
}

// The right colours with the right noise, each in a place that chance gave it.
Tensor shuffled(const Tensor& expected, std::uint64_t seed)
{
    Random random(seed);
    Tensor tensor = expected;
    const auto size = static_cast<std::ptrdiff_t>(size_of(expected.element) * expected.components);
    for (auto i = static_cast<std::ptrdiff_t>(expected.cells()) - 1; i > 0; --i) {
        const auto other = static_cast<std::ptrdiff_t>(random.below(static_cast<std::uint32_t>(i) + 1));
        if (other != i) std::swap_ranges(tensor.bytes.begin() + i * size, tensor.bytes.begin() + (i + 1) * size, tensor.bytes.begin() + other * size);
    }
    return tensor;
}

Row identity(std::size_t components)
{
    const std::size_t side = components == 9 ? 3 : 4;
    Row row(components, 0);
    for (std::size_t i = 0; i < components; i += side + 1) row[i] = 1;
    return row;
}

}

std::vector<std::pair<std::string, Tensor>> controls(const Check& check, const Tensor& expected, std::uint64_t seed)
{
    if (check.judge == JudgeKind::trace) return {{"no call", without_rows(expected)}};
    if (check.judge == JudgeKind::cost) return {{"zeros", filled(expected, Row(expected.components, 0))}, {"returns at once", at_once(expected)}};
    if (check.judge == JudgeKind::noise && is_table(expected)) return estimate_controls(expected, seed);
    const TensorView view(expected);
    const Statistics statistics = statistics_of(view);
    const std::size_t components = expected.components;
    const bool picture = check.judge == JudgeKind::image || check.judge == JudgeKind::noise;
    std::vector<std::pair<std::string, Tensor>> result;
    result.emplace_back("zeros", filled(expected, Row(components, 0)));
    result.emplace_back("ones", filled(expected, Row(components, 1)));
    if (components == 9 || components == 16) result.emplace_back("identity", filled(expected, identity(components)));
    result.emplace_back(picture ? "most frequent colour" : "most frequent row", filled(expected, most_frequent(view, [](std::size_t) { return true; })));
    result.emplace_back(picture ? "mean colour" : "mean row", filled(expected, statistics.mean));
    result.emplace_back("noise", noise(expected, statistics, seed));
    if (picture || check.judge == JudgeKind::buffer) {
        const auto border = [&](std::size_t cell) {
            const std::size_t x = cell % expected.columns;
            const std::size_t y = cell / expected.columns;
            return x == 0 || y == 0 || x + 1 == expected.columns || y + 1 == expected.rows;
        };
        result.emplace_back("blank", filled(expected, most_frequent(view, border)));
    }
    if (check.judge == JudgeKind::fragments && components >= 3)
        if (auto boxes = bounding_boxes(expected, statistics.mean)) result.emplace_back("bounding boxes", std::move(*boxes));
    if (picture) {
        const bool bytes = expected.element == Element::uint8;
        result.emplace_back("black", filled(expected, Row(components, bytes ? 0 : check.range_low)));
        result.emplace_back("white", filled(expected, Row(components, bytes ? 255 : check.range_high)));
    }
    if (check.judge == JudgeKind::noise) result.emplace_back("shuffled pixels", shuffled(expected, seed));
    if (!expected.present.empty()) result.emplace_back("all absent", all_absent(expected));
    return result;
}

BestControl best_control(const Check& check, const Tensor& expected, const Tensor* margin, std::uint64_t seed)
{
    BestControl best{"none", 0};
    for (const auto& [name, tensor] : controls(check, expected, seed))
        if (const double right = fraction_right(check, tensor, expected, margin); best.name == "none" || right > best.right) best = {name, right};
    return best;
}

}
