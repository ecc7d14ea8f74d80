#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "judge/explain/transforms.hpp"
#include "judge/judges.hpp"
#include "judge/rows/rows.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

using Result = std::optional<Tensor>;
constexpr double degree = std::numbers::pi / 180;

bool is_numbers(const Check& check) { return judge_of(check).rows == number_rows; }

template <double (*change)(double), bool matrices_too = false>
Result each_value(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!is_numbers(check) && !(matrices_too && judge_of(check).rows == matrix_rows)) return std::nullopt;
    return map_values(student, expected, change);
}

double negate(double v) { return -v; }
double to_radians(double v) { return v * degree; }
double to_degrees(double v) { return v / degree; }
double reciprocal(double v) { return 1 / v; }
double root(double v) { return std::copysign(std::sqrt(std::abs(v)), v); }
double square(double v) { return v * v; }
double from_one(double v) { return 1 - v; }
double clamp_below(double v) { return std::max(v, 0.0); }

Result normalise(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!is_numbers(check) || student.components < 2 || student.components > 4) return std::nullopt;
    bool unit = true;
    Tensor result = map_cells(student, expected, [&unit](std::span<double> row, std::span<const double> target) {
        const auto length = [](auto values) {
            double sum = 0;
            for (const double v : values) sum += v * v;
            return std::sqrt(sum);
        };
        unit = unit && std::abs(length(target) - 1) < 1e-3;
        const double size = length(row);
        for (double& v : row) v /= size;
    });
    if (!unit) return std::nullopt;
    return result;
}

using Order = std::array<std::size_t, 4>;

// The order of components that brings the student's rows nearest to the expected ones.
std::optional<std::pair<Order, Tensor>> best_order(const Check& check, const Tensor& student, const Tensor& expected)
{
    const std::size_t components = student.components;
    if (!is_numbers(check) || components < 2 || components > 4) return std::nullopt;
    Order order{0, 1, 2, 3};
    std::optional<std::pair<Order, Tensor>> best;
    double nearest = 0;
    while (std::next_permutation(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(components))) {
        Tensor candidate = map_cells(student, expected, [&](std::span<double> row, std::span<const double>) {
            const std::array<double, 4> old{row[0], row[1], components > 2 ? row[2] : 0, components > 3 ? row[3] : 0};
            for (std::size_t i = 0; i < components; ++i) row[i] = old[order[i]];
        });
        const double apart = distance(candidate, expected);
        if (!best || apart < nearest) nearest = apart, best = {order, std::move(candidate)};
    }
    return best;
}

Result reorder(const Check& check, const Tensor& student, const Tensor& expected)
{
    auto best = best_order(check, student, expected);
    if (!best) return std::nullopt;
    return std::move(best->second);
}

std::string describe_order(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto best = best_order(check, student, expected);
    if (!best) return {};
    std::string order;
    for (std::size_t i = 0; i < student.components; ++i)
        order += (i > 0 ? ", " : "") + std::string(1, "xyzw"[best->first[i]]);
    return fmt::format("Your components are right, but in another order: the expected vector is your ({}).", order);
}

// A factor that no other transform names.
std::optional<double> plain_factor(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!is_numbers(check) && judge_of(check).rows != matrix_rows) return std::nullopt;
    const auto pairs = value_pairs(student, expected);
    if (!enough_to_fit(pairs)) return std::nullopt;
    const auto factor = common_factor(pairs);
    if (!factor || *factor == 0 || !std::isfinite(*factor)) return std::nullopt;
    for (const double named : {1.0, -1.0, degree, 1 / degree})
        if (std::abs(*factor / named - 1) < 1e-4) return std::nullopt;
    return factor;
}

Result unscale(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto factor = plain_factor(check, student, expected);
    if (!factor) return std::nullopt;
    return map_cells(student, expected, [f = *factor](std::span<double> row, std::span<const double>) {
        for (double& v : row) v /= f;
    });
}

std::string describe_factor(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto factor = plain_factor(check, student, expected);
    return factor ? fmt::format(
                        "Your values are {:.4g} times the expected ones: a constant factor is missing or too much.",
                        *factor)
                  : std::string{};
}

std::optional<double> plain_offset(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!is_numbers(check)) return std::nullopt;
    const auto pairs = value_pairs(student, expected);
    if (!enough_to_fit(pairs)) return std::nullopt;
    std::vector<double> differences;
    for (const ValuePair& pair : pairs) differences.push_back(pair.student - pair.expected);
    return median(std::move(differences));
}

Result remove_offset(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto offset = plain_offset(check, student, expected);
    if (!offset || *offset == 0) return std::nullopt;
    return map_cells(student, expected, [o = *offset](std::span<double> row, std::span<const double>) {
        for (double& v : row) v -= o;
    });
}

std::string describe_offset(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto offset = plain_offset(check, student, expected);
    if (!offset) return {};
    return fmt::format("Your values are off by the constant {:.4g}: {}.", *offset,
                       *offset > 0 ? "something is added, or counted, that should not be"
                                   : "something is not added, or not counted, that should be");
}

/// So many rows must be in another order: fewer are too soon alike.
constexpr std::uint32_t enough_rows = 8;

/// The student's row `from(i)` in place of row i; where there is none, the expected one.
template <class From>
Result moved_rows(const Check& check, const Tensor& student, const Tensor& expected, From from)
{
    if (!is_numbers(check) || student.columns != 1 || student.rows < enough_rows) return std::nullopt;
    return moved_cells(student, expected, [&](std::size_t row) -> std::optional<std::size_t> {
        const std::int64_t source = from(static_cast<std::int64_t>(row));
        if (source < 0 || source >= student.rows) return std::nullopt;
        return static_cast<std::size_t>(source);
    });
}

Result reverse_rows(const Check& check, const Tensor& student, const Tensor& expected)
{
    return moved_rows(check, student, expected, [&](std::int64_t row) { return student.rows - 1 - row; });
}

template <std::int64_t by>
Result rows_moved_by(const Check& check, const Tensor& student, const Tensor& expected)
{
    return moved_rows(check, student, expected, [](std::int64_t row) { return row + by; });
}

// What lies behind the origin, taken for a hit, made absent.
Result drop_negative(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!is_numbers(check) || student.present.empty() || expected.components != 1) return std::nullopt;
    std::vector<double> values = to_doubles(student);
    Tensor result = student;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (result.present[i] != 0 && values[i] <= 0) result.present[i] = 0, values[i] = 0;
    return with_values(result, values);
}

}

std::vector<NamedTransform> number_transforms()
{
    std::vector<NamedTransform> all = {
        {"negated",
         "Your values have the opposite sign: look for a difference taken the wrong way round, or a direction that "
         "points the other way.",
         each_value<negate, true>},
        {"degrees for radians", "Your values are in degrees, radians were expected: multiply by pi / 180.",
         each_value<to_radians>},
        {"radians for degrees", "Your values are in radians, degrees were expected: multiply by 180 / pi.",
         each_value<to_degrees>},
        {"hits behind", "You report hits at negative distances: what lies behind the ray's origin is no hit.",
         drop_negative},
        {"not clamped",
         "Your values are right where they are positive: negative ones must become 0, as with max(0, n . l).",
         each_value<clamp_below>},
        {"not normalised", "Your vectors point the right way but are not of length 1: normalise them.", normalise},
        {"components swapped", "Your components are right, but in another order.", reorder, describe_order, 5},
        {"reciprocal", "Your values are the reciprocals (1 / x) of the expected ones: a quotient is upside down.",
         each_value<reciprocal>},
        {"squared", "Your values are the squares of the expected ones: a square root is missing.", each_value<root>},
        {"root taken", "Your values are the square roots of the expected ones: the square was expected.",
         each_value<square>},
        {"rows in reverse order", "Your rows are the expected ones in reverse order: the last one comes first.",
         reverse_rows},
        {"rows one too late", "Each of your rows is the expected one of the row before: they come one too late.",
         rows_moved_by<1>},
        {"rows one too early", "Each of your rows is the expected one of the row after: they come one too early.",
         rows_moved_by<-1>},
        {"subtracted from 1", "Your values are 1 minus the expected ones.", each_value<from_one>},
        {"scaled", "Your values differ from the expected ones by a constant factor.", unscale, describe_factor, 6},
        {"off by a constant", "Your values differ from the expected ones by a constant.", remove_offset,
         describe_offset, 6},
    };
    for (NamedTransform& one : recognised_transforms()) all.push_back(std::move(one));
    return all;
}

}
