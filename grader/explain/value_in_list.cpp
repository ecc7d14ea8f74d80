#include "explain/value_in_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "judge/rows/tensor_view.hpp"
#include "question/alike.hpp"

namespace umbral::grader {
namespace {

using Row = std::span<const double>;

constexpr std::size_t most_rows = 400;

/// Is each key the same in all rows, or their number?
bool keys_are_places(const TensorView& list, std::size_t keys)
{
    for (std::size_t row = 0; row < list.cells(); ++row)
        for (std::size_t key = 0; key < keys; ++key)
            if (list.cell(row)[key] != list.cell(0)[key] && list.cell(row)[key] != static_cast<double>(row))
                return false;
    return true;
}

double distance(Row a, Row b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

std::string text_of(Row row)
{
    if (row.size() == 1) return number_text(row.front());
    std::string text = "(";
    for (const double number : row) text += (text.size() > 1 ? ", " : "") + number_text(number);
    return text + ")";
}

}

std::optional<Difference> first_value_apart(const Tensor& yours, const Tensor& expected, std::size_t keys)
{
    const TensorView mine(yours);
    const TensorView right(expected);
    if (keys >= right.components() || right.cells() == 0 || mine.components() != right.components() ||
        std::max(mine.cells(), right.cells()) > most_rows || !keys_are_places(mine, keys) ||
        !keys_are_places(right, keys))
        return std::nullopt;
    std::vector<std::size_t> surplus;
    for (std::size_t i = 0; i < mine.cells(); ++i) surplus.push_back(i);
    std::vector<std::size_t> lacking;
    for (std::size_t i = 0; i < right.cells(); ++i) {
        const Row row = right.cell(i).subspan(keys);
        const auto partner = std::ranges::find_if(
            surplus, [&](std::size_t other) { return alike_rows(mine.cell(other).subspan(keys), row); });
        if (partner != surplus.end())
            surplus.erase(partner);
        else
            lacking.push_back(i);
    }
    if (lacking.empty() && surplus.empty()) return std::nullopt;
    Difference apart{"this call", "nothing", "nothing"};
    if (lacking.empty()) {
        apart.yours = text_of(mine.cell(surplus.front()).subspan(keys));
        return apart;
    }
    const Row row = right.cell(lacking.front()).subspan(keys);
    apart.cell = lacking.front();
    apart.expected = text_of(row);
    const auto nearest = std::ranges::min_element(
        surplus, {}, [&](std::size_t other) { return distance(mine.cell(other).subspan(keys), row); });
    if (nearest != surplus.end()) apart.yours = text_of(mine.cell(*nearest).subspan(keys));
    return apart;
}

}
