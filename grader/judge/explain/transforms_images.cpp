#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <set>
#include <vector>

#include "judge/explain/transforms.hpp"
#include "judge/explain/transforms_tone.hpp"
#include "judge/judges.hpp"
#include "judge/picture/offset_text.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

using Result = std::optional<Tensor>;

bool is_grid(const Check& check) { return has_colours(check) || judge_of(check).look == Look::values; }

// The picture whose pixel (x, y) is the student's at source(x, y).
template <class Source>
Tensor rearranged(const Tensor& student, Source source)
{
    return moved_cells(student, student, [&](std::size_t cell) {
        const auto [x, y] = source(static_cast<std::uint32_t>(cell % student.columns),
                                   static_cast<std::uint32_t>(cell / student.columns));
        return std::optional(std::size_t{y} * student.columns + x);
    });
}

using At = std::pair<std::uint32_t, std::uint32_t>;

Result flip_vertically(const Check& check, const Tensor& student, const Tensor&)
{
    if (!is_grid(check)) return std::nullopt;
    return rearranged(student, [&](std::uint32_t x, std::uint32_t y) { return At{x, student.rows - 1 - y}; });
}

Result flip_horizontally(const Check& check, const Tensor& student, const Tensor&)
{
    if (!is_grid(check)) return std::nullopt;
    return rearranged(student, [&](std::uint32_t x, std::uint32_t y) { return At{student.columns - 1 - x, y}; });
}

Result turn(const Check& check, const Tensor& student, const Tensor&)
{
    if (!is_grid(check)) return std::nullopt;
    return rearranged(student, [&](std::uint32_t x, std::uint32_t y) {
        return At{student.columns - 1 - x, student.rows - 1 - y};
    });
}

/// Which of the two ways it was turned is found out.
Result turn_by_quarter(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!is_grid(check) || student.rows != student.columns) return std::nullopt;
    const std::uint32_t last = student.rows - 1;
    Tensor left = rearranged(student, [last](std::uint32_t x, std::uint32_t y) { return At{y, last - x}; });
    Tensor right = rearranged(student, [last](std::uint32_t x, std::uint32_t y) { return At{last - y, x}; });
    return distance(left, expected) < distance(right, expected) ? std::move(left) : std::move(right);
}

Result swap_axes(const Check& check, const Tensor& student, const Tensor&)
{
    if (!is_grid(check) || student.rows != student.columns) return std::nullopt;
    return rearranged(student, [](std::uint32_t x, std::uint32_t y) { return At{y, x}; });
}

Result swap_red_blue(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!has_colours(check) || student.components < 3) return std::nullopt;
    return map_cells(student, expected,
                     [](std::span<double> pixel, std::span<const double>) { std::swap(pixel[0], pixel[2]); });
}

Result restore_alpha(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!has_colours(check) || student.components != 4) return std::nullopt;
    return map_cells(student, expected,
                     [](std::span<double> pixel, std::span<const double> target) { pixel[3] = target[3]; });
}

std::string describe_alpha(const Check& check, const Tensor& student, const Tensor& expected)
{
    const TensorView yours(student);
    const TensorView target(expected);
    const double opaque = is_real(expected.element) ? check.range_high : 255;
    for (std::size_t cell = 0; cell < target.cells(); ++cell)
        if (yours.cell(cell)[3] != target.cell(cell)[3] && target.cell(cell)[3] != opaque)
            return "Your colours are right; only the alpha differs: look at the fourth component that you write, and "
                   "at how blending changes it.";
    return "Your colours are right; only the alpha differs: an opaque pixel has alpha 255 (1.0 in a shader).";
}

struct Shift {
    int x = 0;
    int y = 0;
};
constexpr int largest_shift = 8;

// The shift of up to largest_shift pixels under which most cells agree; cells are compared by their bytes, as a shift
// changes none.
Shift best_shift(const Tensor& student, const Tensor& expected)
{
    const int width = static_cast<int>(student.columns);
    const int height = static_cast<int>(student.rows);
    const std::size_t size = size_of(student.element) * student.components;
    // Of large pictures every few rows are enough to find the shift; the judge then sees all of them.
    const int step = std::max(1, height / 128);
    const auto keys = [size](const Tensor& tensor) {
        std::vector<std::uint32_t> result(tensor.cells(), 2166136261U);
        for (std::size_t i = 0; i < result.size(); ++i)
            for (std::size_t b = 0; b < size; ++b)
                result[i] = (result[i] ^ std::to_integer<std::uint32_t>(tensor.bytes[i * size + b])) * 16777619U;
        return result;
    };
    const std::vector<std::uint32_t> yours = keys(student);
    const std::vector<std::uint32_t> target = keys(expected);
    Shift best;
    double most = -1;
    for (int dy = -largest_shift; dy <= largest_shift; ++dy)
        for (int dx = -largest_shift; dx <= largest_shift; ++dx) {
            int equal = 0;
            int compared = 0;
            for (int y = std::max(0, dy); y < std::min(height, height + dy); y += step) {
                const std::uint32_t* a = yours.data() + static_cast<std::ptrdiff_t>(y) * width;
                const std::uint32_t* b = target.data() + static_cast<std::ptrdiff_t>(y - dy) * width;
                for (int x = std::max(0, dx); x < std::min(width, width + dx); ++x) equal += a[x] == b[x - dx] ? 1 : 0;
                compared += width - std::abs(dx);
            }
            const double share = compared > 0 ? static_cast<double>(equal) / compared : 0;
            const bool nearer = std::abs(dx) + std::abs(dy) < std::abs(best.x) + std::abs(best.y);
            if (share > most || (share == most && nearer)) most = share, best = {dx, dy};
        }
    return best;
}

// The strip that a shift uncovers cannot be known from the student's picture: it is taken from the expected one.
Result unshift(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!is_grid(check) || student.rows < 3 * largest_shift || student.columns < 3 * largest_shift) return std::nullopt;
    const Shift shift = best_shift(student, expected);
    if (shift.x == 0 && shift.y == 0) return std::nullopt;
    const auto columns = static_cast<int>(student.columns);
    return moved_cells(student, expected, [&](std::size_t cell) -> std::optional<std::size_t> {
        const int x = static_cast<int>(cell) % columns + shift.x;
        const int y = static_cast<int>(cell) / columns + shift.y;
        if (x < 0 || y < 0 || x >= columns || y >= static_cast<int>(student.rows)) return std::nullopt;
        return static_cast<std::size_t>(y) * student.columns + static_cast<std::size_t>(x);
    });
}

std::string describe_shift(const Check&, const Tensor& student, const Tensor& expected)
{
    const Shift shift = best_shift(student, expected);
    return fmt::format(
        "Your picture is the expected one moved by {}: look at the pixel centres (x + 0.5) and at where rounding "
        "happens.",
        offset_text(shift.x, shift.y));
}

// Depth counted from the other end: 1 - z, -z, or mirrored in the expected range; infinite cells stay.
Result invert_depth(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (judge_of(check).look != Look::values || !is_real(student.element)) return std::nullopt;
    double low = INFINITY;
    double high = -INFINITY;
    for (const ValuePair& pair : value_pairs(expected, expected))
        low = std::min(low, pair.expected), high = std::max(high, pair.expected);
    Result best;
    double nearest = 0;
    for (const double sum : {1.0, 0.0, low + high}) {
        Tensor candidate = map_cells(student, expected, [sum](std::span<double> cell, std::span<const double> target) {
            for (std::size_t i = 0; i < cell.size(); ++i)
                if (std::isfinite(cell[i]) && cell[i] != target[i]) cell[i] = sum - cell[i];
        });
        const double apart = distance(candidate, expected);
        if (!best || apart < nearest) nearest = apart, best = std::move(candidate);
    }
    return best;
}

/// Who counts from another number has every id wrong, but that of the background, which is the only one that agrees:
/// whoever takes a thing for the background, or the background for a thing, is one off in these cells alone.
bool may_count_from_another(const std::vector<ValuePair>& pairs)
{
    std::set<double> agreeing;
    for (const ValuePair& pair : pairs)
        if (pair.student == pair.expected) agreeing.insert(pair.expected);
    if (agreeing.size() > 1) return false;
    const auto is_background = [&](double id) { return agreeing.contains(id); };
    return std::ranges::none_of(
               pairs,
               [&](const ValuePair& pair) { return pair.student != pair.expected && is_background(pair.expected); }) &&
           std::ranges::any_of(pairs, [&](const ValuePair& pair) {
               return pair.student != pair.expected && !is_background(pair.student);
           });
}

Result shift_ids(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (judge_of(check).look != Look::values ||
        (student.element != Element::int32 && student.element != Element::uint32))
        return std::nullopt;
    if (!may_count_from_another(value_pairs(student, expected))) return std::nullopt;
    Result best;
    double nearest = 0;
    for (const double by : {1.0, -1.0}) {
        // Cells that agree already are background, which counting from another number leaves alone.
        Tensor candidate = map_cells(student, expected, [by](std::span<double> cell, std::span<const double> target) {
            for (std::size_t i = 0; i < cell.size(); ++i)
                if (cell[i] != target[i]) cell[i] += by;
        });
        const double apart = distance(candidate, expected);
        if (!best || apart < nearest) nearest = apart, best = std::move(candidate);
    }
    return best;
}

}

std::vector<NamedTransform> image_transforms()
{
    std::vector<NamedTransform> all = {
        {"alpha only", "Your colours are right; only the alpha differs.", restore_alpha, describe_alpha, -20},
        {"flipped vertically",
         "Your picture is upside down: top and bottom are exchanged, or rows are counted from the other end (row 0 is "
         "the top one here, while OpenGL counts from the bottom).",
         flip_vertically},
        {"flipped horizontally",
         "Your picture is mirrored left to right: look at the sign of the x axis or of a cross product.",
         flip_horizontally},
        {"turned by 180 degrees", "Your picture is turned upside down and mirrored: both axes have the wrong sign.",
         turn},
        {"turned by 90 degrees",
         "Your picture is turned by a quarter: x and y are swapped, and one of them has the wrong sign.",
         turn_by_quarter, nullptr, 1},
        {"x and y swapped", "Your picture is mirrored at its diagonal: x and y (or width and height) are swapped.",
         swap_axes},
        {"red and blue swapped", "Red and blue are swapped: you write BGR where RGB is expected.", swap_red_blue},
        {"shifted", "Your picture is the expected one moved by whole pixels.", unshift, describe_shift, 8},
        {"depth inverted", "Your depth grows the wrong way: near and far are exchanged (1 - z instead of z).",
         invert_depth, nullptr, 2},
        {"ids off by one", "Your ids are all one off: count from the same number as the statement does.", shift_ids,
         nullptr, 1},
    };
    for (NamedTransform& one : channel_transforms()) all.push_back(std::move(one));
    for (NamedTransform& tone : tone_transforms()) all.push_back(std::move(tone));
    return all;
}

}
