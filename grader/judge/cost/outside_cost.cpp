#include "judge/cost/outside_cost.hpp"

#include <fmt/format.h>

#include <cmath>

#include "judge/explain/thresholds.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rules.hpp"

namespace umbral::grader {
namespace {

/// What so many of the first sizes take together if the work grows with this exponent.
double sum_of_powers(const std::vector<double>& sizes, std::size_t count, double exponent)
{
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += std::pow(sizes[i], exponent);
    return sum;
}

}

std::size_t sizes_to_compare(const std::vector<double>& sizes)
{
    std::size_t count = 1;
    while (count + 1 < sizes.size() && 4 * sizes[count] <= sizes.back()) ++count;
    return count;
}

bool is_worth_measuring(double student, double reference)
{
    return student > thresholds::outside_ratio_unmeasured * reference + thresholds::outside_unmeasured;
}

std::optional<std::string> objection_from_outside(const OutsideCost& student, const OutsideCost& reference,
                                                  const std::vector<double>& sizes, double growth,
                                                  std::string_view names)
{
    if (student.nothing > thresholds::outside_ratio_before * reference.nothing + thresholds::outside_before)
        return fmt::format(
            "{:.0f} ms pass before anything is counted, {:.0f} with the reference: work belongs into the functions "
            "that are asked for",
            student.nothing, reference.nothing);
    const double exponent = growth + thresholds::growth_zero;
    const std::size_t first = sizes_to_compare(sizes);
    const double most = sum_of_powers(sizes, sizes.size(), exponent) / sum_of_powers(sizes, first, exponent);
    const double noise = thresholds::outside_noise;
    const bool grows = student.work() - noise > most * (student.first_work() + noise);
    const bool slow = student.work() - noise > thresholds::outside_ratio * (reference.work() + noise);
    if (!grows || !slow) return std::nullopt;
    return fmt::format(
        "the counted steps are fine, but your code took {:.0f} times the reference's time ({:.0f} ms, {:.1f}), and "
        "from {} to {} {} it grows "
        "faster than that count allows: work was done that is not counted",
        student.work() / std::max(reference.work(), noise), student.work(), reference.work(),
        count_text(sizes[first - 1]), count_text(sizes.back()), names.empty() ? "items" : names);
}

}
