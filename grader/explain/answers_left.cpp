#include "explain/answers_left.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <span>
#include <vector>

#include "explain/simpler_questions.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

constexpr double most_changed = 0.8;  ///< of the right answers: with more, it is another question

std::size_t different_rows(const Tensor& tensor)
{
    std::set<std::vector<std::byte>> rows;
    const std::size_t size = tensor.components * size_of(tensor.element);
    for (std::size_t row = 0; row < tensor.cells(); ++row) {
        const auto bytes = std::span(tensor.bytes).subspan(row * size, size);
        rows.emplace(bytes.begin(), bytes.end());
    }
    return rows.size();
}

bool is_all_zero(const Tensor& tensor)
{
    return std::ranges::all_of(to_doubles(tensor), [](double x) { return x == 0; });
}

/// Is there a right answer to some questions and none to others?
bool is_mixed(const Tensor& tensor)
{
    const auto present = std::ranges::count_if(tensor.present, [](std::uint8_t one) { return one != 0; });
    return present > 0 && static_cast<std::size_t>(present) < tensor.present.size();
}

/// How many of these rows have a right answer.
std::size_t present_among(const Tensor& right, const std::vector<std::size_t>& rows)
{
    return static_cast<std::size_t>(std::ranges::count_if(rows, [&](std::size_t row) {
        return right.present.empty() || (row < right.present.size() && right.present[row] != 0);
    }));
}

}

double share_changed(const Tensor& before, const Tensor& after)
{
    const std::vector<double> one = numbers_or_nan(before);
    const std::vector<double> other = numbers_or_nan(after);
    if (one.size() != other.size()) return 1;
    double size = 0;
    double change = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        if (!std::isfinite(one[i]) || !std::isfinite(other[i])) continue;
        size += std::abs(one[i]);
        change += std::abs(one[i] - other[i]);
    }
    return size > 0 ? std::min(change / size, 1.0) : 1;
}

bool settles_presence(const Tensor& before, const Tensor& after, const std::vector<std::size_t>& rows)
{
    if (rows.empty()) return false;
    const std::size_t were = present_among(before, rows);
    const std::size_t are = present_among(after, rows);
    return were > 0 ? are == 0 : are == rows.size();
}

bool leaves_answers(const OtherQuestion& change, const Tensor& before, const Tensor& after)
{
    const bool same_form = before.rows == after.rows && before.columns == after.columns;
    const std::size_t least = leaves_out(change) || change.change.starts_with("without ") ? 1 : 3;
    if (4 * after.cells() < least * before.cells() || (same_form && share_changed(before, after) > most_changed))
        return false;
    // Where a radius is 0 or infinite nothing is hit, or all, and whoever is wrong about that is right.
    if (is_mixed(before) && !is_mixed(after)) return false;
    return 2 * different_rows(after) > different_rows(before) && (!is_all_zero(after) || is_all_zero(before));
}

bool are_right_by_chance(std::size_t asked, std::size_t wrong)
{
    constexpr double unlikely = 0.01;
    if (asked == 0) return false;
    const double right = 1 - static_cast<double>(wrong) / static_cast<double>(asked);
    return std::pow(right, wrong) > unlikely;
}

}
