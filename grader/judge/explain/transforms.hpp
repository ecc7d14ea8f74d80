#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "judge/explain/explain.hpp"

namespace umbral::grader {

// The named transforms by what they apply to, each list from the most specific to the least.
[[nodiscard]] std::vector<NamedTransform> matrix_transforms();
[[nodiscard]] std::vector<NamedTransform> number_transforms();
[[nodiscard]] std::vector<NamedTransform> image_transforms();
/// Of numbers, what cannot be undone but is recognised: signs, fractions or high bits that are lost.
[[nodiscard]] std::vector<NamedTransform> recognised_transforms();
/// Of pictures, what was done to their channels.
[[nodiscard]] std::vector<NamedTransform> channel_transforms();

/// Is it a picture of colours?
[[nodiscard]] bool has_colours(const Check& check);

/// The student's cells in other places: in each the one that stands at `from(cell)`, an optional index, with its
/// presence; where that is none, the cell of `rest`. Both tensors have one shape.
template <class From>
[[nodiscard]] Tensor moved_cells(const Tensor& student, const Tensor& rest, From from)
{
    Tensor result = rest;
    const std::size_t size = size_of(student.element) * student.components;
    for (std::size_t to = 0; to < student.cells(); ++to) {
        const std::optional<std::size_t> source = from(to);
        if (!source) continue;
        std::copy_n(student.bytes.begin() + static_cast<std::ptrdiff_t>(*source * size), size,
                    result.bytes.begin() + static_cast<std::ptrdiff_t>(to * size));
        if (!student.present.empty()) result.present[to] = student.present[*source];
    }
    return result;
}

using CellMap = std::function<void(std::span<double> student, std::span<const double> expected)>;

/// The student's tensor with every cell that both sides have passed through `change`.
[[nodiscard]] Tensor map_cells(const Tensor& student, const Tensor& expected, const CellMap& change);

/// The same for every value by itself.
[[nodiscard]] Tensor map_values(const Tensor& student, const Tensor& expected, double (*change)(double));

/// Pairs of finite values that both sides have.
struct ValuePair {
    double student = 0;
    double expected = 0;
};
[[nodiscard]] std::vector<ValuePair> value_pairs(const Tensor& student, const Tensor& expected);

/// Are there enough different expected values for a fitted number to mean something? One equation always has a
/// solution.
[[nodiscard]] bool enough_to_fit(const std::vector<ValuePair>& pairs);

/// The middle value; nothing of an empty list.
[[nodiscard]] std::optional<double> median(std::vector<double> values);

/// The factor between the two sides, from the values that are not almost zero; nothing if it is not one factor for most
/// of them.
[[nodiscard]] std::optional<double> common_factor(const std::vector<ValuePair>& pairs);

/// Mean distance of two tensors of one shape, non-finite values counting as far apart: which of several candidates fits
/// best.
[[nodiscard]] double distance(const Tensor& a, const Tensor& b);

}
