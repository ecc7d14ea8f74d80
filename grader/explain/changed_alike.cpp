#include "explain/changed_alike.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "explain/samples.hpp"
#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"
#include "question/changed_rows.hpp"
#include "worker/spent_on_runs.hpp"

namespace umbral::grader {
namespace {

NumberRows numbers_in(const Tensor& tensor)
{
    const TensorView view(tensor);
    NumberRows rows;
    for (std::size_t row = 0; row < tensor.rows; ++row)
        if (view.present(row)) rows.emplace_back(view.cell(row).begin(), view.cell(row).end());
    return rows;
}

/// "the opposite sign of y", "its second and third number exchanged": numbers without names are counted behind those
/// that say what the row is about.
std::string how_changed(const ChangedRows& found, std::size_t first, const std::vector<std::string>& names)
{
    constexpr std::array ordinals = {"first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth"};
    const auto is_named = [&](std::size_t number) { return number < names.size() && !names[number].empty(); };
    const auto counted = [&](std::size_t number) {
        const std::size_t place = number - first;
        return place < ordinals.size() ? std::string(ordinals[place]) : fmt::format("{}th", place + 1);
    };
    const bool named = is_named(found.one) && is_named(found.other);
    if (found.how == ChangedRows::How::negated)
        return named ? "the opposite sign of " + names[found.one]
                     : fmt::format("the opposite sign of its {} number", counted(found.one));
    return named ? fmt::format("{} and {} exchanged", names[found.one], names[found.other])
                 : fmt::format("its {} and {} number exchanged", counted(found.one), counted(found.other));
}

}

std::string changed_alike(Worker& worker, const AskedCheck& asked, SpareTime& time)
{
    const Check& check = asked.check;
    const JudgeRecord& judge = judge_of(check);
    if (!time.is_left() || check.relation || !judge.free_rows || !judge.plain_values) return "";
    const SpentOnRuns spent(time, worker);
    const std::uint64_t seed = input_seed(asked, 0);
    const RunOutcome& right_run = worker.trusted(asked.exercise, judged_against(check), check.case_name, seed);
    const Expected expected = expected_of(check, right_run);
    const Tensor* const yours = observed(check, asked.runs.plain(seed));
    if (expected.value == nullptr || yours == nullptr || !well_formed(*yours) || yours->columns > 1 ||
        yours->components != expected.value->components)
        return "";
    const std::size_t first = judge.kinds != nullptr ? 1 : judge.keys;
    const NumberRows right = numbers_in(*expected.value);
    const auto found = changed_rows(numbers_in(*yours), right, first);
    if (!found) return "";
    std::vector<std::string> names;
    // The corners of a triangle are no x, y and z.
    const bool whole = std::ranges::all_of(
        right, [](const auto& row) { return std::ranges::all_of(row, [](double x) { return x == std::floor(x); }); });
    if (judge.columns != nullptr && !whole) names = judge.columns(text_of(expected.names), expected.value->components);
    return fmt::format("each row that is not expected is one that is missing, with {} ({} of {})",
                       how_changed(*found, first, names), found->rows, found->all);
}

}
