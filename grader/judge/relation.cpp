#include "judge/relation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "judge/explain/likeness.hpp"
#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rules.hpp"

namespace umbral::grader {
namespace {

/// The law may hold for the reference's unmoved values up to this; above, there is nothing left to tell.
constexpr double most_unmoved = 0.9;

/// "Rotating scene and camera together must not change the picture."
std::string law(const Relation& relation)
{
    std::string text = relation.what + ".";
    if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

std::vector<const Tensor*> list_of(const RelatedTensors& tensors, bool three)
{
    std::vector<const Tensor*> list{tensors.value, tensors.to};
    if (three) list.push_back(tensors.unlike);
    return list;
}

Tensor scaled(const Check& check, const Tensor& tensor, double factor)
{
    std::vector<double> values = to_doubles(tensor);
    const bool with_alpha = judge_of(check).look == Look::colours && tensor.components == 4;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!with_alpha || i % 4 != 3) values[i] *= factor;
    return with_values(tensor, values);
}

Tensor moved_cells(const Tensor& to, const Tensor& value, const std::array<int, 2>& shift)
{
    Tensor result = value;
    if (!to.present.empty() && result.present.empty()) result.present.assign(result.cells(), 1);
    const std::size_t size = to.components * size_of(to.element);
    for (std::int64_t y = 0; y < to.rows; ++y)
        for (std::int64_t x = 0; x < to.columns; ++x) {
            const std::int64_t from_x = x - shift[0];
            const std::int64_t from_y = y - shift[1];
            if (from_x < 0 || from_y < 0 || from_x >= to.columns || from_y >= to.rows) continue;
            const auto cell = static_cast<std::size_t>(y * to.columns + x);
            const auto from = static_cast<std::size_t>(from_y * to.columns + from_x);
            std::memcpy(result.bytes.data() + cell * size, to.bytes.data() + from * size, size);
            if (!result.present.empty()) result.present[cell] = to.present.empty() ? std::uint8_t{1} : to.present[from];
        }
    return result;
}

/// Without the cells that come in from outside: they have no value then.
Tensor compared_cells(const Tensor& value, const std::array<int, 2>& shift)
{
    Tensor result = value;
    if (result.present.empty()) result.present.assign(result.cells(), 1);
    for (std::int64_t y = 0; y < value.rows; ++y)
        for (std::int64_t x = 0; x < value.columns; ++x)
            if (x < shift[0] || y < shift[1] || x - shift[0] >= value.columns || y - shift[1] >= value.rows)
                result.present[static_cast<std::size_t>(y * value.columns + x)] = 0;
    return result;
}

/// Can this be held up as the expected side? The rules take values that are not finite there for a fault of the
/// grader's.
bool presentable(const Check& check, const Tensor& expected)
{
    if (expected.cells() == 0) return false;
    if (const auto own = judge_of(check).relation.presentable) return own(expected);
    const TensorView view(expected);
    for (std::size_t cell = 0; cell < view.cells(); ++cell)
        if (view.present(cell) && !all_finite(view.cell(cell))) return false;
    return true;
}

}

std::optional<Tensor> expected_by_relation(const Check& check, const Tensor& to, const Tensor& value)
{
    const Relation& relation = *check.relation;
    Tensor expected = relation.scales() ? scaled(check, to, relation.scale) : to;
    const auto move = judge_of(check).relation.moved;
    if (relation.moves())
        expected = move != nullptr ? move(expected, relation.shift) : moved_cells(expected, value, relation.shift);
    if (!presentable(check, expected)) return std::nullopt;
    return expected;
}

std::string expected_in_words(const Relation& relation)
{
    std::string text = fmt::format("your own '{}'", relation.to);
    if (relation.scales()) text += fmt::format(", times {:g}", relation.scale);
    if (relation.moves()) text += fmt::format(", moved by ({}, {}) pixels", relation.shift[0], relation.shift[1]);
    return text;
}

RelationJudge::RelationJudge(const Check& check, const RelatedTensors& reference, const Tensor* margin,
                             std::uint64_t seed)
    : check_(check), relation_(*check_.relation), margin_(margin)
{
    const auto fault = [&](const std::string& what) {
        throw std::invalid_argument(fmt::format("check '{}': its relation tells nothing: {}", check.name, what));
    };
    const bool three = !relation_.unlike.empty();
    const std::array names{&check.value, &relation_.to, &relation_.unlike};
    const std::vector<const Tensor*> tensors = list_of(reference, three);
    for (std::size_t i = 0; i < tensors.size(); ++i) {
        if (tensors[i] == nullptr) fault(fmt::format("the driver recorded nothing called '{}'", *names[i]));
        if (!well_formed(*tensors[i]) || !presentable(check, *tensors[i]))
            fault(fmt::format("'{}' is empty, or not finite", *names[i]));
        if (const auto error = shape_error(check, *tensors[i], *reference.value))
            fault(fmt::format("'{}' has another shape than '{}'", *names[i], check.value));
        if (relation_.scales() && tensors[i]->element != Element::float32 && tensors[i]->element != Element::float64 &&
            !judge_of(check).relation.whole_numbers_scale)
            fault(fmt::format("'{}' holds whole numbers, which no factor applies to", *names[i]));
        if (!likeness(check, *tensors[i], *tensors[i]))
            fault(fmt::format("'{}' is the same everywhere, or has fewer than 32 values", *names[i]));
        sides_.push_back({tensors[i], 0, *names[i]});
    }
    reference_unmoved_ = unmoved(reference);
    if (reference_unmoved_ > most_unmoved)
        fault(three ? fmt::format("'{}' is almost like '{}', and must not be", relation_.unlike, relation_.to)
                    : fmt::format("'{}' satisfies it almost as it is, unmoved", relation_.to));

    std::vector<std::vector<std::pair<std::string, Tensor>>> of_sides;
    for (const Side& side : sides_) of_sides.push_back(grader::controls(check, *side.reference, seed));
    for (auto& [name, tensor] : of_sides[0]) {
        RelatedControl control{name, std::move(tensor), {}, {}};
        const auto take = [&, &wanted = name](std::size_t side, Tensor& target) {
            for (auto& [other, its] : of_sides[side])
                if (other == wanted) target = std::move(its);
        };
        take(1, control.to);
        if (three) take(2, control.unlike);
        controls_.push_back(std::move(control));
    }
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        double best = 0;
        for (const RelatedControl& control : controls_)
            if (const Tensor* tensor = list_of(control.tensors(), three)[i]; tensor != nullptr && tensor->cells() > 0)
                best = std::max(best, alike(i, *tensor));
        sides_[i].least = (1 + best) / 2;
    }
}

double RelationJudge::alike(std::size_t side, const Tensor& tensor) const
{
    const Tensor& reference = *sides_[side].reference;
    if (side > 0 || !relation_.moves() || judge_of(check_).relation.moved != nullptr)
        return *likeness(check_, tensor, reference);
    return *likeness(check_, compared_cells(tensor, relation_.shift), compared_cells(reference, relation_.shift));
}

double RelationJudge::unmoved(const RelatedTensors& values) const
{
    double best = 0;
    if (relation_.moves() || relation_.scales())
        if (const auto expected = expected_by_relation(check_, *values.to, *values.to))
            best = fraction_right(check_, *values.to, *expected, margin_);
    if (!relation_.unlike.empty()) best = std::max(best, fraction_right(check_, *values.unlike, *values.to, margin_));
    return best;
}

std::string RelationJudge::problem(const RelatedTensors& student) const
{
    const std::vector<const Tensor*> tensors = list_of(student, sides_.size() == 3);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        const Side& side = sides_[i];
        if (tensors[i] == nullptr)
            return fmt::format("Nothing was recorded as '{}': the run was disturbed.", side.name);
        if (const auto error = shape_error(check_, *tensors[i], *side.reference))
            return fmt::format("Of '{}': {}", side.name, *error);
    }
    // What unmoved() holds up must be finite too.
    if (!presentable(check_, *student.to) || !expected_by_relation(check_, *student.to, *student.value))
        return fmt::format("Your '{}' is empty, or holds values that are not finite: nothing can follow from it.",
                           relation_.to);
    return {};
}

std::string RelationJudge::worthless(const RelatedTensors& student, Judgement& judgement) const
{
    const std::vector<const Tensor*> tensors = list_of(student, sides_.size() == 3);
    judgement.metrics["likeness"] = 1;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        const double found = alike(i, *tensors[i]);
        judgement.metrics["likeness"] = std::min(judgement.metrics["likeness"], found);
        if (found < sides_[i].least)
            return fmt::format("your '{}' has too little in common with what is asked for.", sides_[i].name);
    }
    const double still = unmoved(student);
    judgement.metrics["unmoved"] = still;
    judgement.right = std::max(0.0, (judgement.right - still) / (1 - still));
    if (1 - still >= 0.5 * (1 - reference_unmoved_)) return {};
    return relation_.unlike.empty()
               ? fmt::format("your '{}' hardly changes where it must.", relation_.to)
               : fmt::format("your '{}' must differ from your '{}', and hardly does.", relation_.unlike, relation_.to);
}

Judgement RelationJudge::judge(const RelatedTensors& student, const Tensor* names) const
{
    Judgement result;
    result.message = problem(student);
    if (!result.message.empty()) return result;
    result = grader::judge(check_, *student.value, *expected_by_relation(check_, *student.to, *student.value), margin_,
                           names);
    // Rows of the other recording are no rows of this one.
    if (result.first_difference && judge_of(check_).free_rows) result.first_difference->cell.reset();
    for (std::string* const text : {&result.message, &result.headline})
        if (!text->empty())
            *text = fmt::format("{} Expected here is {}. {}", law(relation_), expected_in_words(relation_), *text);
    if (const std::string why = worthless(student, result); !why.empty()) {
        result.right = 0;
        result.headline.clear();
        result.message += (result.message.empty() ? law(relation_) + " Yours agree, which tells nothing: "
                                                  : ". And it could tell nothing: ") +
                          why;
    }
    return result;
}

BestControl RelationJudge::best_control() const
{
    BestControl best{"none", 0};
    for (const RelatedControl& control : controls_)
        if (const double right = judge(control.tensors()).right; best.name == "none" || right > best.right)
            best = {control.name, right};
    return best;
}

}
