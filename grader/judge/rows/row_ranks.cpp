#include "judge/rows/row_ranks.hpp"

#include <algorithm>
#include <numeric>

#include "judge/rows/whole_number.hpp"

namespace umbral::grader {
namespace {

/// Of two sequences in order: what is smaller has no partner.
Alignment merged(const RowRanks& ranks)
{
    Alignment alignment;
    for (std::size_t i = 0, j = 0; i < ranks.a.size() && j < ranks.b.size();) {
        if (ranks.a[i] == ranks.b[j])
            alignment.matches.emplace_back(i++, j++);
        else
            ++(ranks.a[i] < ranks.b[j] ? i : j);
    }
    return alignment;
}

}

std::optional<RowRanks> ranks_of_whole_rows(const TensorView& a, std::size_t rows_of_a, const TensorView& b)
{
    if (a.components() != b.components()) return std::nullopt;
    const auto row = [&](std::size_t i) { return i < rows_of_a ? a.cell(i) : b.cell(i - rows_of_a); };
    std::vector<std::size_t> order(rows_of_a + b.cells());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!std::ranges::all_of(order, [&](std::size_t i) { return std::ranges::all_of(row(i), is_whole_number); }))
        return std::nullopt;
    std::ranges::sort(
        order, [&](std::size_t i, std::size_t j) { return std::ranges::lexicographical_compare(row(i), row(j)); });
    std::vector<std::uint32_t> ranks(order.size());
    for (std::size_t place = 1; place < order.size(); ++place) {
        const bool is_next = !std::ranges::equal(row(order[place]), row(order[place - 1]));
        ranks[order[place]] = ranks[order[place - 1]] + (is_next ? 1U : 0U);
    }
    const auto middle = ranks.begin() + static_cast<std::ptrdiff_t>(rows_of_a);
    return RowRanks{{ranks.begin(), middle}, {middle, ranks.end()}};
}

Alignment align(const RowRanks& ranks)
{
    if (std::ranges::is_sorted(ranks.a) && std::ranges::is_sorted(ranks.b)) return merged(ranks);
    return align(ranks.a.size(), ranks.b.size(),
                 [&](std::size_t i, std::size_t j) { return ranks.a[i] == ranks.b[j]; });
}

}
