#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include "judge/explain/transforms.hpp"
#include "judge/judges.hpp"
#include "judge/rows/rows.hpp"

namespace umbral::grader {
namespace {

using Result = std::optional<Tensor>;

/// So many different values must be recognised: a constant answer is what many changes make of some values.
constexpr std::size_t enough_values = 4;

bool near(double a, double b) { return a == b || std::abs(a - b) <= 1e-5 * std::max(std::abs(a), std::abs(b)); }

bool equal(double a, double b) { return a == b; }

/// The student's tensor with the expected value wherever the student's is `same` as what `change` makes of it; and with
/// what `change` makes of the expected value wherever the student's is that, though it should not be.
template <double (*change)(double), bool (*same)(double, double)>
Tensor undone(const Tensor& student, const Tensor& expected)
{
    return map_cells(student, expected, [](std::span<double> row, std::span<const double> target) {
        for (std::size_t i = 0; i < row.size(); ++i)
            if (same(row[i], change(target[i])))
                row[i] = target[i];
            else if (same(row[i], target[i]))
                row[i] = change(target[i]);
    });
}

/// What cannot be undone is recognised. Nothing where that changes no value, leaves none as it is, or is true of few
/// different ones.
template <double (*change)(double), bool at_both_ends = false>
Result recognised(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (judge_of(check).rows != number_rows) return std::nullopt;
    std::set<double> changed;
    std::set<double> left;
    for (const ValuePair& pair : value_pairs(student, expected)) {
        if (!near(pair.student, change(pair.expected))) continue;
        (near(pair.student, pair.expected) ? left : changed).insert(pair.expected);
    }
    if (changed.empty() || left.empty() || changed.size() + left.size() < enough_values) return std::nullopt;
    if (at_both_ends && (*changed.begin() > 0 || *changed.rbegin() < 0)) return std::nullopt;
    return undone<change, near>(student, expected);
}

double without_sign(double v) { return std::abs(v); }
double within_unit(double v) { return std::clamp(v, 0.0, 1.0); }
double not_negative(double v) { return std::max(v, 0.0); }
double at_most_one(double v) { return std::min(v, 1.0); }
double of_16_bits(double v)
{
    const bool whole = v >= 0 && v < 0x1p53 && v == std::floor(v);
    return whole ? static_cast<double>(static_cast<std::uint64_t>(v) % 65536U) : v;
}

/// Fractions cut off leave nothing as it is but whole numbers: at least enough_values different results must be there.
template <double (*change)(double)>
Result whole(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (judge_of(check).rows != number_rows) return std::nullopt;
    std::set<double> results;
    bool cut = false;
    for (const ValuePair& pair : value_pairs(student, expected)) {
        if (pair.student != change(pair.expected)) continue;
        results.insert(pair.student);
        cut = cut || pair.student != pair.expected;
    }
    if (!cut || results.size() < enough_values) return std::nullopt;
    return undone<change, equal>(student, expected);
}

double cut_off(double v) { return std::trunc(v); }
double rounded(double v) { return std::round(v); }

}

std::vector<NamedTransform> recognised_transforms()
{
    return {
        {"sign lost", "Your values are right but for their sign: negative ones come out positive.",
         recognised<without_sign>},
        {"limited below", "Your values are right where they are positive: 0 comes where a negative one is expected.",
         recognised<not_negative>},
        {"limited above", "Your values are right up to 1: 1 comes where a larger one is expected.",
         recognised<at_most_one>},
        {"limited to [0, 1]", "Your values are the expected ones limited to [0, 1]: nothing here asks for that.",
         recognised<within_unit, true>},
        {"fractions cut off",
         "Your values are the expected ones without their fractions: look for an int where a float is meant, such as a "
         "quotient of integers.",
         whole<cut_off>},
        {"rounded to whole numbers", "Your values are the expected ones rounded to whole numbers.", whole<rounded>},
        {"16 bits", "Your values are the expected ones modulo 65536: look for an integer type of 16 bits.",
         recognised<of_16_bits>},
    };
}

}
