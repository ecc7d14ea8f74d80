#include <cmath>
#include <limits>
#include <optional>

#include "judge/fragments/fragments.hpp"
#include "judge/rows/tolerance.hpp"

namespace umbral::grader {
namespace {

// Whole numbers as far as one can add pixels to them without overflow.
std::optional<std::int32_t> whole(double value)
{
    constexpr double largest = 1 << 30;
    if (!(std::abs(value) <= largest) || value != std::trunc(value)) return std::nullopt;
    return static_cast<std::int32_t>(value);
}

Scale scale_of(std::span<const double> attributes, std::size_t index)
{
    double largest = 0;
    for (const double value : attributes) largest = std::max(largest, std::abs(value));
    return {float_ulp(attributes[index]), largest};
}

}

FragmentTable::FragmentTable(const Tensor& tensor) : view_(tensor)
{
    sorted_.reserve(view_.cells());
    for (std::size_t row = 0; row < view_.cells(); ++row) {
        const auto cell = view_.cell(row);
        const auto primitive = whole(cell[0]);
        const auto x = whole(cell[1]);
        const auto y = whole(cell[2]);
        if (primitive && x && y) sorted_.push_back({{*primitive, *y, *x}, static_cast<std::uint32_t>(row)});
    }
    std::sort(sorted_.begin(), sorted_.end());
}

Fragments FragmentTable::of(std::int32_t primitive) const
{
    const auto of_primitive = [](const Fragment& fragment) { return fragment.place.primitive; };
    const auto first = std::ranges::lower_bound(sorted_, primitive, {}, of_primitive);
    const auto last = std::ranges::upper_bound(sorted_, primitive, {}, of_primitive);
    return {first, last};
}

FragmentTally& FragmentTally::operator+=(const FragmentTally& other)
{
    matched += other.matched;
    wrong_value += other.wrong_value;
    missing += other.missing;
    extra += other.extra;
    duplicated += other.duplicated;
    return *this;
}

FragmentTally FragmentMatcher::at_place(Fragments yours, Fragments expected) const
{
    const std::size_t both = std::min(yours.size(), expected.size());
    FragmentTally tally;
    if (expected.size() == 1)
        tally.matched =
            std::ranges::any_of(yours, [&](const Fragment& fragment) { return compare(fragment, expected[0]).right; })
                ? 1
                : 0;
    else
        for (std::size_t i = 0; i < both; ++i) tally.matched += compare(yours[i], expected[i]).right ? 1 : 0;
    tally.wrong_value = both - tally.matched;
    tally.missing = expected.size() - both;
    tally.extra = expected.empty() && !yours.empty() ? 1 : 0;
    tally.duplicated = yours.size() - both - tally.extra;
    return tally;
}

FragmentMatcher::Comparison FragmentMatcher::compare(const Fragment& yours, const Fragment& expected) const
{
    const auto target = expected_.attributes(expected);
    const auto values = yours_.attributes(yours);
    Comparison result;
    for (std::size_t i = 0; i < target.size(); ++i) {
        const Deviation found = deviation(check_.tolerance, values[i], target[i], scale_of(target, i));
        result.right = result.right && found.right;
        if (!found.right || found.within) result.error = std::max(result.error, found.error);
    }
    return result;
}

}
