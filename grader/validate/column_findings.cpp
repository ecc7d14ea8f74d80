#include "validate/column_findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "judge/controls.hpp"
#include "judge/rows/columns.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

constexpr double least_of_table = 1e-6;  ///< a column whose largest is below this part of the table's is rounding
constexpr double least_of_column = 0.1;  ///< a value below this part of its column's largest is not looked at

struct Spoiling {
    const char* what;
    double factor;
};
constexpr Spoiling spoilings[] = {{"be 0", 0}, {"have the other sign", -1}};

/// May the column's values be multiplied by the factor, and no row is wrong of those whose value says something?
bool excuses(const Check& check, const Expected& expected, const TensorView& view, std::size_t column, double least,
             double factor)
{
    std::vector<double> values(view.values().begin(), view.values().end());
    for (std::size_t row = 0; row < view.cells(); ++row) values[row * view.components() + column] *= factor;
    const std::vector<RowState> states = single_rows(check, with_values(*expected.value, values), expected);
    bool seen = false;
    for (std::size_t row = 0; row < states.size(); ++row) {
        if (states[row] == RowState::left_out || !view.present(row) || std::abs(view.cell(row)[column]) < least)
            continue;
        if (states[row] == RowState::wrong) return false;
        seen = true;
    }
    return seen;
}

}

std::string column_complaint(const Check& check, const Expected& expected)
{
    if (!has_single_rows(check, expected.value, expected.value)) return "";
    const TensorView view(*expected.value);
    if (view.components() < 2 || !all_finite(view.values())) return "";
    const ComponentStatistics statistics = component_statistics(*expected.value);
    std::vector<double> most(view.components());
    for (std::size_t column = 0; column < most.size(); ++column)
        most[column] = std::max(std::abs(statistics.low[column]), std::abs(statistics.high[column]));
    const double of_table = *std::ranges::max_element(most);
    std::vector<std::string> names = column_names(text_of(expected.names), view.components(), check.value);
    if (names.empty())
        for (std::size_t column = 0; column < most.size(); ++column) names.push_back(fmt::format("[{}]", column));
    std::vector<std::string> complaints;
    for (std::size_t column = 0; column < most.size(); ++column) {
        if (most[column] == 0 || most[column] < least_of_table * of_table) continue;
        for (const Spoiling& one : spoilings)
            if (excuses(check, expected, view, column, least_of_column * most[column], one.factor)) {
                complaints.push_back(fmt::format("'{}' may {}", names[column], one.what));
                break;
            }
    }
    if (complaints.empty()) return "";
    return fmt::format(
        "{} in every row, and no row is wrong: the tolerance is larger than these numbers are. Give them a check of "
        "their own, or a tolerance that they can exceed",
        fmt::join(complaints, ", "));
}

std::vector<Finding> expect_columns(Worker& worker, const Exercise& exercise, const SeedPlan& seeds, unsigned seed)
{
    std::vector<Finding> findings;
    for (const Check& check : exercise.checks) {
        const std::uint64_t case_seed = seeds.seed_of(exercise, check.case_name);
        const Expected expected =
            expected_of(check, worker.trusted(exercise, judged_against(check), check.case_name, case_seed));
        if (std::string complaint = column_complaint(check, expected); !complaint.empty())
            findings.push_back(
                {exercise.id, "columns: " + check.name, seed, false, 0, "each counts", std::move(complaint)});
    }
    return findings;
}

}
