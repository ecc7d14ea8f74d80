#include "judge/picture/image_difference.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "judge/explain/thresholds.hpp"
#include "judge/judges.hpp"
#include "judge/picture/image_rule.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

// Levels per unit of the values; 0 where values are names and any difference is the whole difference.
double levels_per_unit(const Check& check, const Tensor& tensor, const TensorView& expected)
{
    const bool measured = is_real(tensor.element);
    if (judge_of(check).look == Look::colours) return measured ? 255 / (check.range_high - check.range_low) : 1;
    if (!measured) return 0;
    double low = INFINITY;
    double high = -INFINITY;
    for (const double value : expected.values())
        if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    return high > low ? 255 / (high - low) : 0;
}

std::uint8_t level(const TensorView& student, const TensorView& expected, std::size_t cell, double scale)
{
    if (!student.present(cell) || !expected.present(cell))
        return student.present(cell) == expected.present(cell) ? 0 : 255;
    double largest = 0;
    for (std::size_t i = 0; i < expected.components(); ++i) {
        const double yours = student.cell(cell)[i];
        const double target = expected.cell(cell)[i];
        if (yours == target) continue;
        if (!std::isfinite(yours) || !std::isfinite(target) || scale == 0) return 255;
        // A difference that exists is never shown as none.
        largest = std::max({largest, std::abs(yours - target) * scale, 1.0});
    }
    return static_cast<std::uint8_t>(std::min(255.0, std::round(largest)));
}

Window bounds_of(const Grid<std::uint8_t>& map)
{
    int left = map.width;
    int right = -1;
    int top = map.height;
    int bottom = -1;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            if (map.at(x, y) == 0) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    return right < 0 ? Window{} : Window{left, top, right - left + 1, bottom - top + 1};
}

// Sums over every window from a table of sums over the rectangles that start in the corner.
Window worst_window(const Grid<std::uint8_t>& map)
{
    const int wide = std::min(thresholds::worst_window, map.width);
    const int high = std::min(thresholds::worst_window, map.height);
    const std::size_t stride = static_cast<std::size_t>(map.width) + 1;
    std::vector<std::uint64_t> sums(stride * (static_cast<std::size_t>(map.height) + 1), 0);
    const auto at = [stride](int x, int y) {
        return static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x);
    };
    for (int y = 0; y < map.height; ++y) {
        std::uint64_t row = 0;
        for (int x = 0; x < map.width; ++x) {
            row += map.cells[static_cast<std::size_t>(y) * (stride - 1) + static_cast<std::size_t>(x)];
            sums[at(x + 1, y + 1)] = row + sums[at(x + 1, y)];
        }
    }
    Window best{0, 0, wide, high};
    std::uint64_t most = 0;
    for (int y = 0; y + high <= map.height; ++y)
        for (int x = 0; x + wide <= map.width; ++x) {
            const std::uint64_t sum =
                sums[at(x + wide, y + high)] + sums[at(x, y)] - sums[at(x + wide, y)] - sums[at(x, y + high)];
            if (sum > most) most = sum, best = Window{x, y, wide, high};
        }
    return best;
}

}

Grid<std::uint8_t> difference_map(const Check& check, const Tensor& student_tensor, const Tensor& expected_tensor)
{
    if (!well_formed(expected_tensor) || shape_error(student_tensor, expected_tensor))
        throw std::invalid_argument("check '" + check.name +
                                    "': a map of differences needs two recordings of one shape and type");
    if (const auto own = judge_of(check).difference_map) return own(check, student_tensor, expected_tensor);
    Grid<std::uint8_t> map(static_cast<int>(expected_tensor.columns), static_cast<int>(expected_tensor.rows));
    if (judge_of(check).look == Look::colours && expected_tensor.element == Element::uint8 &&
        student_tensor.present.empty() && expected_tensor.present.empty() && expected_tensor.cells() > 0) {
        map.cells = channel_difference(to_picture(check, student_tensor), to_picture(check, expected_tensor));
        return map;
    }
    const TensorView student(student_tensor);
    const TensorView expected(expected_tensor);
    const double scale = levels_per_unit(check, expected_tensor, expected);
    for (std::size_t cell = 0; cell < expected.cells(); ++cell) map.cells[cell] = level(student, expected, cell, scale);
    return map;
}

std::optional<WorstRegion> worst_region(const Check& check, const Tensor& student, const Tensor& expected)
{
    const Grid<std::uint8_t> map = difference_map(check, student, expected);
    WorstRegion region;
    region.bounds = bounds_of(map);
    if (region.bounds.width == 0) return std::nullopt;
    region.worst = worst_window(map);
    region.peak_x = region.worst.x;
    region.peak_y = region.worst.y;
    for (int y = region.worst.y; y < region.worst.y + region.worst.height; ++y)
        for (int x = region.worst.x; x < region.worst.x + region.worst.width; ++x)
            if (map.at(x, y) > map.at(region.peak_x, region.peak_y)) region.peak_x = x, region.peak_y = y;
    return region;
}

}
