#include "explain/value_in_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "judge/rows/tensor_view.hpp"
#include "question/list_patterns.hpp"
#include "question/lost_rows.hpp"

namespace umbral::grader {
namespace {

using Row = std::vector<double>;

constexpr std::size_t most_rows = 400;

double distance(const Row& a, const Row& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

/// How far a row that came is from being an expected one: one with the same numbers in another order, as of a triangle
/// that is turned over, is nearer than any other.
std::pair<bool, double> apart_from(const Row& came, const Row& expected)
{
    return {!std::ranges::is_permutation(came, expected), distance(came, expected)};
}

/// The rows without their keys.
std::vector<Row> values_of(const TensorView& list, std::size_t keys)
{
    std::vector<Row> rows;
    for (std::size_t i = 0; i < list.cells(); ++i) {
        const auto values = list.cell(i).subspan(keys);
        rows.emplace_back(values.begin(), values.end());
    }
    return rows;
}

/// Are these the rows of a list, and few enough to be shown whole?
bool is_short_list(const TensorView& list, std::size_t keys)
{
    constexpr std::size_t keys_of_lists = 3;
    constexpr std::size_t most_shown = 8;
    if (keys != keys_of_lists || list.cells() == 0 || list.cells() > most_shown) return false;
    for (std::size_t i = 0; i < list.cells(); ++i)
        if (list.cell(i)[1] != static_cast<double>(i) || list.cell(i)[2] != 0) return false;
    return true;
}

std::string text_of(const std::vector<Row>& rows, int digits)
{
    std::vector<std::string> all;
    for (const Row& row : rows) all.push_back(row_text(row, digits));
    return fmt::format("{}", fmt::join(all, ", "));
}

/// The places of those that are true.
std::vector<std::size_t> places_of(const std::vector<bool>& all)
{
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i]) places.push_back(i);
    return places;
}

}

std::optional<Difference> first_value_apart(const Tensor& yours, const Tensor& expected, std::size_t keys)
{
    const TensorView mine(yours);
    const TensorView right(expected);
    if (keys >= right.components() || right.cells() == 0 || mine.components() != right.components() ||
        std::max(mine.cells(), right.cells()) > most_rows || !keys_are_places(mine.values(), mine.components(), keys) ||
        !keys_are_places(right.values(), right.components(), keys))
        return std::nullopt;
    const std::vector<Row> my_rows = values_of(mine, keys);
    const std::vector<Row> right_rows = values_of(right, keys);
    const std::vector<std::size_t> lacking = places_of(without_partner(right_rows, my_rows));
    const std::vector<std::size_t> surplus = places_of(without_partner(my_rows, right_rows));
    if (lacking.empty() && surplus.empty()) return std::nullopt;
    Difference apart{"this call", "nothing", "nothing"};
    if (lacking.empty()) {
        apart.yours = row_text(my_rows[surplus.front()]);
        return apart;
    }
    const Row& row = right_rows[lacking.front()];
    apart.cell = lacking.front();
    apart.expected = row_text(row);
    const auto nearest =
        std::ranges::min_element(surplus, {}, [&](std::size_t other) { return apart_from(my_rows[other], row); });
    if (nearest != surplus.end()) apart.yours = row_text(my_rows[*nearest]);
    return apart;
}

std::optional<Difference> short_lists(const Tensor& yours, const Tensor& expected, std::size_t keys)
{
    const TensorView mine(yours);
    const TensorView right(expected);
    if (!is_short_list(mine, keys) || !is_short_list(right, keys)) return std::nullopt;
    const std::vector<Row> my_rows = values_of(mine, keys);
    const std::vector<Row> right_rows = values_of(right, keys);
    auto [my_text, right_text] =
        telling_apart([&](int digits) { return std::pair(text_of(my_rows, digits), text_of(right_rows, digits)); });
    return Difference{"this call", std::move(my_text), std::move(right_text)};
}

}
