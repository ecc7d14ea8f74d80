#include "judge/rows/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "judge/rows/columns.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_shown_whole = 4;  ///< numbers of a row that are read as one: a vector

struct RowError {
    bool right = true;
    bool comparable = false;  ///< both sides have a value
    double error = 0;         ///< the worst of its components; infinite if not finite
};

[[noreturn]] void fault(const Check& check, const std::string& what)
{
    throw std::invalid_argument("check '" + check.name + "': " + what);
}

/// The components of a row that are wrong; none where either side has no value.
std::vector<std::size_t> wrong_components(const Check& check, const TensorView& student, const TensorView& expected,
                                          std::size_t row, const RowKind& kind)
{
    std::vector<std::size_t> wrong;
    if (!student.present(row) || !expected.present(row)) return wrong;
    const auto target = expected.cell(row);
    for (std::size_t i = 0; i < target.size(); ++i)
        if (!deviation(check.tolerance, student.cell(row)[i], target[i], kind.scale(target, i)).right)
            wrong.push_back(i);
    return wrong;
}

RowError compare_row(const Check& check, const TensorView& student, const TensorView& expected, std::size_t index,
                     const RowKind& kind)
{
    RowError row;
    if (!student.present(index) || !expected.present(index)) {
        row.right = student.present(index) == expected.present(index);
        return row;
    }
    row.comparable = true;
    const auto target = expected.cell(index);
    if (!all_finite(target))
        fault(check, fmt::format("the expected {} {} is not finite, so nothing can match it", kind.one, index));
    for (std::size_t i = 0; i < target.size(); ++i) {
        const Deviation found = deviation(check.tolerance, student.cell(index)[i], target[i], kind.scale(target, i));
        row.right = row.right && found.right;
        if (!found.right || found.within) row.error = std::max(row.error, found.error);
    }
    return row;
}

std::vector<bool> counted_rows(const Check& check, const Tensor* margin, std::size_t rows)
{
    std::vector<bool> counted(rows, true);
    if (check.pairs && rows % 2 != 0)
        fault(check, fmt::format("pairs need an even number of rows, the expected recording has {}", rows));
    if (margin == nullptr || !check.tolerance.band_ulps) return counted;
    if (!well_formed(*margin) || margin->count() != rows)
        fault(check, fmt::format("its margin must hold one number a row: expected {}, got {}", rows, margin->count()));
    const std::vector<double> margins = to_doubles(*margin);
    // A margin that is not a number cannot vouch for its row.
    for (std::size_t i = 0; i < rows; ++i) counted[i] = std::abs(margins[i]) >= *check.tolerance.band_ulps;
    if (check.pairs)
        for (std::size_t i = 0; i < rows; i += 2) counted[i] = counted[i + 1] = counted[i] && counted[i + 1];
    return counted;
}

/// "2" becomes "2 (orthogonal)" where the column's name has a word for it.
void add_word(const std::string& column, double value, std::string& text)
{
    const std::string word = column_word(column, value).word;
    if (word == "true" || word == "false")
        text = word;
    else if (!word.empty())
        text += " (" + word + ")";
}

/// Do the numbers of a row have names of their own, which a reader of "(4, 0, 6)" would have to look up? Not x, y, z,
/// nor the coordinates of one vector.
bool has_own_names(const std::vector<std::string>& columns, std::size_t components)
{
    constexpr std::size_t longest_letter = 2;
    if (components < 2 || components > most_shown_whole || columns.size() != components) return false;
    const std::string_view first = columns.front();
    const std::string_view vector = first.substr(0, std::min(first.find('.'), first.size() - 1) + 1);
    const bool is_vector = vector.ends_with('.') && std::ranges::all_of(columns, [&](const std::string& column) {
                               return column.starts_with(vector);
                           });
    return !is_vector && std::ranges::none_of(columns, &std::string::empty) &&
           std::ranges::any_of(columns, [](const std::string& column) { return column.size() > longest_letter; });
}

/// "nodes 4, thrown 2 (TooManyInstances)".
std::string with_names(const RowPairs& pairs, const TensorView& view, std::size_t row, int digits)
{
    if (!view.present(row)) return pairs.kind.show(view, row, 0, digits);
    std::string all;
    for (std::size_t i = 0; i < view.components(); ++i) {
        std::string number = pairs.kind.show_number(view.cell(row), i, digits);
        add_word(pairs.columns[i], view.cell(row)[i], number);
        all += fmt::format("{}{} {}", i == 0 ? "" : ", ", column_word(pairs.columns[i], 0).name, number);
    }
    return all;
}

/// Is the first wrong number of a row a code, which has a word for what it is or should be?
bool is_code(const RowPairs& pairs, std::size_t row)
{
    const std::vector<std::size_t> wrong =
        wrong_components(pairs.check, pairs.student, pairs.expected, row, pairs.kind);
    if (wrong.empty() || pairs.columns.size() != pairs.expected.components() || !pairs.expected.present(row))
        return false;
    return !column_word(pairs.columns[wrong.front()], pairs.expected.cell(row)[wrong.front()]).word.empty();
}

void add_quantiles(std::vector<double> errors, std::map<std::string, double>& metrics)
{
    if (errors.empty()) return;
    std::sort(errors.begin(), errors.end());
    // The nearest-rank quantile: always an error that occurred.
    const auto quantile = [&](double share) {
        return errors[static_cast<std::size_t>(std::ceil(share * static_cast<double>(errors.size()))) - 1];
    };
    metrics["median_error"] = quantile(0.5);
    metrics["p95_error"] = quantile(0.95);
    metrics["max_error"] = errors.back();
}

}

std::string wrong_columns(const RowPairs& pairs, std::size_t row)
{
    const auto& [check, student, expected, kind, columns] = pairs;
    const std::vector<std::size_t> wrong = wrong_components(check, student, expected, row, kind);
    if (wrong.empty() || columns.size() != expected.components()) return "";
    const std::string first = column_word(columns[wrong.front()], 0).name;
    if (wrong.size() == 1) return first;
    if (first.empty() || expected.components() <= most_shown_whole) return "";
    return fmt::format("{} and {} other{} of it", first, wrong.size() - 1, wrong.size() == 2 ? "" : "s");
}

Difference row_difference(const RowPairs& pairs, std::size_t row)
{
    const auto& [check, student, expected, kind, columns] = pairs;
    const std::size_t components = expected.components();
    const std::vector<std::size_t> wrong = wrong_components(check, student, expected, row, kind);
    const std::size_t first = wrong.empty() ? 0 : wrong.front();
    const std::string names = wrong_columns(pairs, row);
    Difference result{kind.where(row, components, first) + (names.empty() ? "" : ", " + names), "", "", row};
    const bool alone = !names.empty() && components > most_shown_whole;
    if (has_own_names(columns, components)) {
        std::tie(result.yours, result.expected) = telling_apart([&](int digits) {
            return std::pair(with_names(pairs, student, row, digits), with_names(pairs, expected, row, digits));
        });
        return result;
    }
    std::tie(result.yours, result.expected) = telling_apart([&](int digits) {
        return alone ? std::pair(kind.show_number(student.cell(row), first, digits),
                                 kind.show_number(expected.cell(row), first, digits))
                     : std::pair(kind.show(student, row, first, digits), kind.show(expected, row, first, digits));
    });
    if (!wrong.empty() && columns.size() == components && (alone || components == 1)) {
        add_word(columns[first], student.cell(row)[first], result.yours);
        add_word(columns[first], expected.cell(row)[first], result.expected);
    }
    return result;
}

std::vector<RowState> row_states(const Check& check, const Tensor& student_tensor, const Tensor& expected_tensor,
                                 const Tensor* margin, const RowKind& kind)
{
    const TensorView student(student_tensor);
    const TensorView expected(expected_tensor);
    const std::vector<bool> counted = counted_rows(check, margin, expected.cells());
    std::vector<RowState> states(expected.cells(), RowState::left_out);
    for (std::size_t i = 0; i < states.size(); ++i)
        if (counted[i])
            states[i] = compare_row(check, student, expected, i, kind).right ? RowState::right : RowState::wrong;
    return states;
}

Judgement judge_rows(const Check& check, const Tensor& student_tensor, const Tensor& expected_tensor,
                     const Tensor* margin, const RowKind& kind, const std::vector<std::string>& columns)
{
    if (!has_bound(check.tolerance)) fault(check, "a tolerance is needed: absolute, relative or ulps");
    const TensorView student(student_tensor);
    const TensorView expected(expected_tensor);
    const std::vector<bool> counted = counted_rows(check, margin, expected.cells());
    const std::size_t group = check.pairs ? 2 : 1;
    const Check wide = with_wide_bounds(check);

    std::size_t units = 0;
    std::size_t wrong_units = 0;
    std::size_t rows = 0;
    std::size_t wrong = 0;
    std::size_t clearly_wrong = 0;
    std::size_t missing = 0;
    std::size_t extra = 0;
    std::size_t not_finite = 0;
    std::vector<double> errors;
    std::optional<std::size_t> first_wrong;
    std::optional<std::size_t> worst_wrong;
    RowError worst;
    for (std::size_t start = 0; start < expected.cells(); start += group) {
        bool unit_right = true;
        if (!counted[start]) continue;
        for (std::size_t i = start; i < start + group; ++i) {
            const RowError row = compare_row(check, student, expected, i, kind);
            ++rows;
            if (row.comparable && std::isfinite(row.error)) errors.push_back(row.error);
            if (!std::isfinite(row.error)) ++not_finite;
            if (row.right) continue;
            unit_right = false;
            ++wrong;
            if (!compare_row(wide, student, expected, i, kind).right) ++clearly_wrong;
            if (!row.comparable) ++(expected.present(i) ? missing : extra);
            if (!first_wrong) first_wrong = i;
            if (!worst_wrong || row.error > worst.error) worst_wrong = i, worst = row;
        }
        ++units;
        if (!unit_right) ++wrong_units;
    }
    if (units == 0)
        fault(check, "no row counts: the recording is empty, or every row lies in the band that is left out");

    Judgement result;
    result.clearly_wrong = clearly_wrong;
    result.right = static_cast<double>(units - wrong_units) / static_cast<double>(units);
    if (not_finite == 0 && (!errors.empty() || wrong == 0))
        result.error = errors.empty() ? 0.0 : *std::max_element(errors.begin(), errors.end());
    result.metrics["rows"] = static_cast<double>(rows);
    result.metrics["wrong"] = static_cast<double>(wrong);
    if (check.pairs) {
        result.metrics["pairs"] = static_cast<double>(units);
        result.metrics["wrong_pairs"] = static_cast<double>(wrong_units);
    }
    if (student.optional() || expected.optional()) {
        result.metrics["missing_hits"] = static_cast<double>(missing);
        result.metrics["false_hits"] = static_cast<double>(extra);
    }
    if (not_finite > 0) result.metrics["not_finite"] = static_cast<double>(not_finite);
    add_quantiles(std::move(errors), result.metrics);
    if (!first_wrong) return result;

    const RowPairs pairs{check, student, expected, kind, columns};
    result.first_difference = row_difference(pairs, *first_wrong);
    const Difference shown = row_difference(pairs, *worst_wrong);
    // Of codes and counts the difference says nothing, or what one sees.
    const bool has_distance = worst.comparable && std::isfinite(worst.error) && is_real(expected_tensor.element) &&
                              !is_code(pairs, *worst_wrong);
    const std::string distance = has_distance ? " (" + error_text(unit_of(check.tolerance), worst.error) + ")" : "";
    const std::string of = rows == 1 ? fmt::format("The only {} is wrong: ", kind.one)
                                     : fmt::format("{} of {} {} {} wrong; the worst is ", wrong, rows, kind.many,
                                                   wrong == 1 ? "is" : "are");
    result.headline = of + shown.where;
    result.message = fmt::format("{}: yours {}, expected {}{}", result.headline, shown.yours, shown.expected, distance);
    return result;
}

}
