#include "question/changed_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace umbral::grader {
namespace {

constexpr std::size_t least_rows = 3;
constexpr std::size_t most_rows = 4000;   ///< that are looked at
constexpr std::size_t most_numbers = 12;  ///< of a row
constexpr double least_changed = 0.9;     ///< of the rows that came

/// Rows with how often they stand there.
using Counted = std::map<std::vector<double>, std::size_t>;

/// Six digits: the seventh may be rounding.
double rounded(double x)
{
    if (!std::isfinite(x) || x == 0) return std::isnan(x) ? 1e300 : x + 0.0;
    const double unit = std::pow(10, std::floor(std::log10(std::abs(x))) - 5);
    return std::abs(x) < 1e-7 ? 0 : std::round(x / unit) * unit + 0.0;
}

std::vector<double> rounded(std::vector<double> row)
{
    for (double& x : row) x = rounded(x);
    return row;
}

Counted counted(const NumberRows& rows)
{
    Counted all;
    for (const std::vector<double>& row : rows) ++all[rounded(row)];
    return all;
}

NumberRows without(const NumberRows& rows, Counted others)
{
    NumberRows left;
    for (const std::vector<double>& row : rows) {
        const auto found = others.find(rounded(row));
        if (found == others.end() || found->second == 0)
            left.push_back(row);
        else
            --found->second;
    }
    return left;
}

template <class Change>
std::size_t made_right(const NumberRows& too_many, Counted missing, const Change& change)
{
    std::size_t count = 0;
    for (std::vector<double> row : too_many) {
        const std::vector<double> before = row;
        change(row);
        if (row == before) continue;
        const auto found = missing.find(rounded(std::move(row)));
        if (found == missing.end() || found->second == 0) continue;
        --found->second;
        ++count;
    }
    return count;
}

}

std::pair<NumberRows, NumberRows> unpaired(const NumberRows& yours, const NumberRows& right)
{
    return {without(yours, counted(right)), without(right, counted(yours))};
}

std::optional<ChangedRows> changed_rows(const NumberRows& yours, const NumberRows& right, std::size_t first)
{
    if (yours.size() > most_rows || right.size() > most_rows) return std::nullopt;
    const auto [too_many, missing_rows] = unpaired(yours, right);
    if (too_many.size() < least_rows || missing_rows.empty()) return std::nullopt;
    const std::size_t numbers = too_many.front().size();
    if (numbers > most_numbers) return std::nullopt;
    const Counted missing = counted(missing_rows);
    std::optional<ChangedRows> best;
    const auto offer = [&](ChangedRows::How how, std::size_t one, std::size_t other, const auto& change) {
        const std::size_t rows = made_right(too_many, missing, change);
        if (static_cast<double>(rows) < least_changed * static_cast<double>(too_many.size())) return;
        if (!best || rows > best->rows) best = ChangedRows{how, one, other, rows, too_many.size()};
    };
    for (std::size_t i = first; i < numbers; ++i) {
        for (std::size_t j = i + 1; j < numbers; ++j)
            offer(ChangedRows::How::exchanged, i, j, [i, j](auto& row) { std::swap(row[i], row[j]); });
        offer(ChangedRows::How::negated, i, i, [i](auto& row) { row[i] = -row[i]; });
    }
    return best;
}

}
