#include "judge/explain/resemblances.hpp"

#include <algorithm>
#include <cmath>

#include "judge/explain/thresholds.hpp"
#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rules.hpp"

namespace umbral::grader {
namespace {

/// What one event, fragment or count that is wrong in the same way says.
constexpr double bits_each = 3;

/// Are rows of numbers, a cell each, off the expected ones by the same but for this share of it?
std::vector<bool> equally_off(const Tensor& student, const Tensor& expected, const Tensor& mistake, double share)
{
    const TensorView yours(student);
    const TensorView right(expected);
    const TensorView its(mistake);
    if (yours.cells() != right.cells() || its.cells() != right.cells() || yours.components() != right.components() ||
        its.components() != right.components())
        return {};
    std::vector<bool> result(right.cells());
    for (std::size_t i = 0; i < result.size(); ++i) {
        double off = 0;
        double between = 0;
        for (std::size_t c = 0; c < right.components(); ++c) {
            off = std::max(off, std::abs(yours.cell(i)[c] - right.cell(i)[c]));
            between = std::max(between, std::abs(yours.cell(i)[c] - its.cell(i)[c]));
        }
        result[i] = yours.present(i) && right.present(i) && its.present(i) && between <= share * off;
    }
    return result;
}

}

const RowKind& rows_of(const Check& check)
{
    const auto rows = judge_of(check).rows;
    return rows != nullptr ? rows() : number_rows();
}

std::vector<bool> counted(const std::vector<RowState>& states)
{
    std::vector<bool> result(states.size());
    for (std::size_t i = 0; i < states.size(); ++i) result[i] = states[i] != RowState::left_out;
    return result;
}

Tensor comparable_table(const Tensor& tensor, const Tensor& expected)
{
    if (tensor.cells() == 0) {
        Tensor empty = expected;
        empty.rows = 0;
        empty.bytes.clear();
        empty.present.clear();
        return empty;
    }
    return made_finite(tensor);
}

/// A few numbers that agree, each of which says something; one alone if everything is lost, as with code that does
/// nothing.
Resemblance alike(std::size_t agreeing, bool nothing_at_all)
{
    return {Says::for_it,
            nothing_at_all ? 1 : std::min(bits_each * static_cast<double>(agreeing), thresholds::most_value_bits)};
}

/// Pixels that differ by more than rounding can.
std::vector<bool> different_pixels(const Check& check, const Tensor& a_tensor, const Tensor& b_tensor)
{
    const TensorView a(a_tensor);
    const TensorView b(b_tensor);
    const double range = a_tensor.element == Element::uint8 ? 255 : check.range_high - check.range_low;
    const double levels = thresholds::background_levels * range / 255;
    std::vector<bool> result(a.cells());
    for (std::size_t i = 0; i < result.size(); ++i)
        for (std::size_t c = 0; c < a.components(); ++c)
            result[i] = result[i] || !(std::abs(a.cell(i)[c] - b.cell(i)[c]) <= levels);
    return result;
}

/// What a student may be off the right answer by, is more than two ways to the same wrong one differ by.
Check tightened(Check check)
{
    if (check.tolerance.relative) check.tolerance.relative = std::min(*check.tolerance.relative, 1e-2);
    if (check.tolerance.absolute) check.tolerance.absolute = std::min(*check.tolerance.absolute, 0.5);
    return check;
}

Resemblance same_rows(const FailingCheck& failing, const Tensor& mistake_tensor)
{
    Check check = *failing.check;
    check.pairs = false;
    if (!has_bound(check.tolerance)) check.tolerance.absolute = 0;
    const RowKind& kind = rows_of(check);
    const Tensor student = made_finite(*failing.student);
    const Tensor expected = made_finite(*failing.expected);
    const Tensor mistake = made_finite(mistake_tensor);
    const auto student_states = row_states(check, student, expected, failing.margin, kind);
    const auto mistake_states = row_states(check, mistake, expected, failing.margin, kind);
    const auto agreement = row_states(tightened(check), student, mistake, failing.margin, kind);
    const std::vector<bool> rounded =
        failing.rounding > 0 ? equally_off(student, expected, mistake, failing.rounding) : std::vector<bool>();
    std::size_t deviating = 0;
    std::size_t agreeing = 0;
    bool student_deviates = false;
    bool mistake_deviates = false;
    std::vector<bool> alike(agreement.size());
    for (std::size_t i = 0; i < agreement.size(); ++i) {
        const bool yours = student_states[i] == RowState::wrong;
        const bool its = mistake_states[i] == RowState::wrong;
        student_deviates = student_deviates || yours;
        mistake_deviates = mistake_deviates || its;
        if (!yours && !its) continue;
        ++deviating;
        alike[i] = agreement[i] == RowState::right || (rounded.size() == alike.size() && rounded[i]);
        if (alike[i]) ++agreeing;
    }
    if (!student_deviates || !mistake_deviates ||
        static_cast<double>(agreeing) < thresholds::mistake_share * static_cast<double>(deviating))
        return not_alike;
    return {Says::for_it, agreement_bits(*failing.student, *failing.expected, counted(student_states), alike)};
}

Resemblance same_picture(const FailingCheck& failing, const Tensor& mistake)
{
    const Check& check = *failing.check;
    if (fraction_right(check, *failing.student, *failing.expected, nullptr) >= 1 ||
        fraction_right(check, mistake, *failing.expected, nullptr) >= 1)
        return not_alike;
    // A mistake's picture that is not finite is no picture to compare with.
    const auto is_finite = [](const Tensor& tensor) { return all_finite(to_doubles(tensor)); };
    const bool same = *failing.student == mistake ||
                      (is_finite(mistake) && fraction_right(check, *failing.student, mistake, nullptr) >= 1);
    if (!same) return not_alike;
    const auto alike = different_pixels(check, *failing.student, *failing.expected);
    return {Says::for_it,
            agreement_bits(*failing.student, *failing.expected, std::vector<bool>(alike.size(), true), alike)};
}

}
