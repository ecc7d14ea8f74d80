#include "judge/controls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <umbral/core/random.hpp>
#include <utility>

#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rules.hpp"

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

Tensor all_absent(const Tensor& expected)
{
    Tensor tensor = shaped(expected);
    std::fill(tensor.present.begin(), tensor.present.end(), std::uint8_t{0});
    return tensor;
}

/// Which cell comes most often, of those that it is shown; cells with NaN are not counted. Bytes decide what is equal.
class MostFrequent {
public:
    explicit MostFrequent(const TensorView& view) : view_(view) {}

    void see(std::size_t cell)
    {
        const auto values = view_.cell(cell);
        if (!view_.present(cell) || std::ranges::any_of(values, [](double v) { return std::isnan(v); })) return;
        // Neighbours in pictures are mostly equal: these need no search.
        if (last_ == nullptr || !std::ranges::equal(last_->first, values))
            last_ = &*counts_.try_emplace(Row(values.begin(), values.end()), 0).first;
        if (++last_->second > most_) most_ = last_->second, best_ = &last_->first;
    }
    /// Zeros if it was shown none.
    [[nodiscard]] Row cell() const { return best_ != nullptr ? *best_ : Row(view_.components(), 0); }

private:
    const TensorView& view_;
    std::map<Row, std::size_t> counts_;
    std::pair<const Row, std::size_t>* last_ = nullptr;
    std::size_t most_ = 0;
    const Row* best_ = nullptr;
};

Row most_frequent(const TensorView& view)
{
    MostFrequent most(view);
    for (std::size_t cell = 0; cell < view.cells(); ++cell) most.see(cell);
    return most.cell();
}

/// The two rows that are most often a pair, in one order and in the other by turns, so that half of those pairs are
/// right: what guessing their order leads to. Whoever answers yes first and no second, or by turns, has that on
/// average; in the few pairs of one check chance may give them all, and yet right work must earn something.
Tensor pairs_by_chance(const Tensor& expected)
{
    using RowBytes = std::vector<std::byte>;
    const std::size_t bytes = expected.bytes.size() / expected.cells();
    const auto row_of = [&](std::size_t row) {
        const auto own = std::span(expected.bytes).subspan(row * bytes, bytes);
        RowBytes all(own.begin(), own.end());
        if (!expected.present.empty()) all.push_back(std::byte{expected.present[row]});
        return all;
    };
    const auto pair_of = [&](std::size_t pair) {
        std::pair<RowBytes, RowBytes> rows{row_of(2 * pair), row_of(2 * pair + 1)};
        if (rows.second < rows.first) std::swap(rows.first, rows.second);
        return rows;
    };
    const std::size_t pairs = expected.cells() / 2;
    std::map<std::pair<RowBytes, RowBytes>, std::size_t> counts;
    for (std::size_t pair = 0; pair < pairs; ++pair) ++counts[pair_of(pair)];
    const auto& [first, second] =
        std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })->first;
    Tensor tensor = expected;
    const auto write = [&](std::size_t row, const RowBytes& what) {
        std::copy_n(what.begin(), bytes, tensor.bytes.begin() + static_cast<std::ptrdiff_t>(row * bytes));
        if (!tensor.present.empty()) tensor.present[row] = std::to_integer<std::uint8_t>(what.back());
    };
    std::size_t seen = 0;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        const bool begins_with_second = row_of(2 * pair) != first;
        const bool turned = pair_of(pair) == std::pair(first, second) && seen++ % 2 == 0;
        write(2 * pair, begins_with_second != turned ? second : first);
        write(2 * pair + 1, begins_with_second != turned ? first : second);
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

/// The most frequent cell of the border everywhere.
Tensor blank(const Tensor& expected, const TensorView& view)
{
    const std::size_t columns = expected.columns;
    MostFrequent most(view);
    for (std::size_t row = 0; row < expected.rows; ++row) {
        const bool whole = row == 0 || row + 1 == expected.rows;
        const std::size_t step = whole || columns < 2 ? 1 : columns - 1;
        for (std::size_t column = 0; column < columns; column += step) most.see(row * columns + column);
    }
    return filled(expected, most.cell());
}

/// Noise that is right as often as noise is on average. In a small table one draw may happen to be all right: one in
/// 512 of nine answers yes or no, and then right work would earn nothing.
Tensor typical_noise(const Check& check, const Tensor& expected, const ComponentStatistics& statistics,
                     std::uint64_t seed)
{
    constexpr std::size_t small = 64;
    constexpr std::uint64_t draws = 9;
    if (expected.cells() > small) return noise_within(expected, statistics, seed);
    const Tensor finite = made_finite(expected);
    std::vector<std::pair<double, Tensor>> all;
    for (std::uint64_t draw = 0; draw < draws; ++draw) {
        Tensor noise = noise_within(expected, statistics, seed + draw);
        const double right = fraction_right(check, noise, finite, nullptr);
        all.emplace_back(right, std::move(noise));
    }
    const auto median = all.begin() + static_cast<std::ptrdiff_t>(draws / 2);
    std::ranges::nth_element(all, median, {}, &std::pair<double, Tensor>::first);
    return std::move(median->second);
}

}

Tensor filled(const Tensor& expected, const std::vector<double>& row)
{
    Tensor one{expected.element, 1, 1, expected.components, {}, {}};
    one.bytes.resize(size_of(one.element) * one.components);
    const std::vector<std::byte> cell = with_values(one, row).bytes;
    Tensor tensor = shaped(expected);
    for (std::size_t i = 0; i < tensor.bytes.size(); i += cell.size()) std::ranges::copy(cell, &tensor.bytes[i]);
    return tensor;
}

ComponentStatistics component_statistics(const Tensor& expected)
{
    const TensorView view(expected);
    const std::size_t components = view.components();
    ComponentStatistics result{Row(components, 0), Row(components, std::numeric_limits<double>::infinity()),
                               Row(components, -std::numeric_limits<double>::infinity())};
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

Tensor noise_within(const Tensor& expected, const ComponentStatistics& statistics, std::uint64_t seed)
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
        if (tensor.present[cell] == 0)
            std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(cell * width), width, 0.0);
    return with_values(tensor, values);
}

Controls common_controls(const Check& check, const Tensor& expected, std::uint64_t seed)
{
    const TensorView view(expected);
    const ComponentStatistics statistics = component_statistics(expected);
    const std::size_t components = expected.components;
    const Look look = judge_of(check).look;
    const bool picture = look == Look::colours || look == Look::light;
    Controls result;
    result.emplace_back("zeros", filled(expected, Row(components, 0)));
    result.emplace_back("ones", filled(expected, Row(components, 1)));
    if (components == 9 || components == 16) result.emplace_back("identity", filled(expected, identity(components)));
    result.emplace_back(picture ? "most frequent colour" : "most frequent row", filled(expected, most_frequent(view)));
    if (check.pairs && expected.cells() >= 2 && expected.cells() % 2 == 0)
        result.emplace_back("pairs by chance", pairs_by_chance(expected));
    result.emplace_back(picture ? "mean colour" : "mean row", filled(expected, statistics.mean));
    result.emplace_back("noise", typical_noise(check, expected, statistics, seed));
    if (look != Look::none) result.emplace_back("blank", blank(expected, view));
    if (picture) {
        const bool bytes = expected.element == Element::uint8;
        result.emplace_back("black", filled(expected, Row(components, bytes ? 0 : check.range_low)));
        result.emplace_back("white", filled(expected, Row(components, bytes ? 255 : check.range_high)));
    }
    if (!expected.present.empty()) result.emplace_back("all absent", all_absent(expected));
    return result;
}

Controls controls(const Check& check, const Tensor& expected, std::uint64_t seed)
{
    const JudgeRecord& judge = judge_of(check);
    return judge.controls != nullptr ? judge.controls(check, expected, seed) : common_controls(check, expected, seed);
}

BestControl best_control(const Check& check, const Tensor& expected, const Tensor* margin, std::uint64_t seed)
{
    BestControl best{"none", 0};
    const Controls all = controls(check, expected, seed);
    for (auto one = all.begin(); one != all.end(); ++one) {
        // Zeros may be black as well, and the mean the most frequent.
        if (std::ranges::find(all.begin(), one, one->second, &Controls::value_type::second) != one) continue;
        if (const double right = fraction_right(check, one->second, expected, margin);
            best.name == "none" || right > best.right)
            best = {one->first, right};
    }
    return best;
}

}
