#include "judge/explain/transforms.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <set>

#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {

bool has_colours(const Check& check) { return judge_of(check).look == Look::colours; }

Tensor map_cells(const Tensor& student, const Tensor& expected, const CellMap& change)
{
    const TensorView target(expected);
    const TensorView source(student);
    std::vector<double> values(source.values().begin(), source.values().end());
    const std::size_t components = source.components();
    for (std::size_t cell = 0; cell < source.cells(); ++cell)
        if (source.present(cell) && target.present(cell))
            change({values.data() + cell * components, components}, target.cell(cell));
    return with_values(student, values);
}

Tensor map_values(const Tensor& student, const Tensor& expected, double (*change)(double))
{
    return map_cells(student, expected, [change](std::span<double> row, std::span<const double>) {
        for (double& value : row) value = change(value);
    });
}

std::vector<ValuePair> value_pairs(const Tensor& student, const Tensor& expected)
{
    const TensorView source(student);
    const TensorView target(expected);
    std::vector<ValuePair> pairs;
    for (std::size_t cell = 0; cell < source.cells(); ++cell)
        for (std::size_t c = 0; c < source.components() && source.present(cell) && target.present(cell); ++c)
            if (std::isfinite(source.cell(cell)[c]) && std::isfinite(target.cell(cell)[c]))
                pairs.push_back({source.cell(cell)[c], target.cell(cell)[c]});
    return pairs;
}

bool enough_to_fit(const std::vector<ValuePair>& pairs)
{
    std::set<double> distinct;
    for (const ValuePair& pair : pairs)
        if (pair.expected != 0) distinct.insert(pair.expected);
    return distinct.size() >= 3;
}

std::optional<double> median(std::vector<double> values)
{
    if (values.empty()) return std::nullopt;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::optional<double> common_factor(const std::vector<ValuePair>& pairs)
{
    double largest = 0;
    for (const ValuePair& pair : pairs) largest = std::max(largest, std::abs(pair.expected));
    std::vector<double> ratios;
    for (const ValuePair& pair : pairs)
        if (std::abs(pair.expected) > 1e-3 * largest) ratios.push_back(pair.student / pair.expected);
    return median(std::move(ratios));
}

double distance(const Tensor& a, const Tensor& b)
{
    // Pictures are compared by the dozen.
    if (a.element == Element::uint8 && b.element == Element::uint8)
        return static_cast<double>(std::transform_reduce(
            a.bytes.begin(), a.bytes.end(), b.bytes.begin(), std::uint64_t{0}, std::plus<>(),
            [](std::byte x, std::byte y) {
                return static_cast<std::uint64_t>(std::abs(std::to_integer<int>(x) - std::to_integer<int>(y)));
            }));
    const std::vector<double> one = to_doubles(a);
    const std::vector<double> other = to_doubles(b);
    double sum = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        const double apart = std::abs(one[i] - other[i]);
        sum += std::isfinite(apart) ? std::min(apart, 1e100) : 1e100;
    }
    return sum;
}

}
