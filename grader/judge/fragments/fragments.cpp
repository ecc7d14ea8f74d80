#include "judge/fragments/fragments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "judge/fragments/rule.hpp"
#include "judge/rows/tolerance.hpp"

namespace umbral::grader {
namespace {

/// A place where something is wrong, with the fragments of both sides.
struct BadPlace {
    Place place;
    Fragments yours;
    Fragments expected;
};

struct Comparison {
    FragmentTally tally;
    std::size_t wrong_place = 0;
    std::vector<MovedPrimitive> moved;
    std::optional<BadPlace> first_uncovered;  ///< where fragments are missing, extra or there again
    std::optional<BadPlace> first_changed;    ///< where only values are wrong
    double error = 0;                         ///< the worst of the fragments that both sides have
};

Comparison compare(const FragmentTable& yours, const FragmentTable& expected, const FragmentMatcher& matcher,
                   bool can_move)
{
    Comparison result;
    for_each_place(yours.sorted(), expected.sorted(), [&](const Place& place, Fragments here, Fragments there) {
        const FragmentTally tally = matcher.at_place(here, there);
        result.tally += tally;
        for (std::size_t i = 0; i < std::min(here.size(), there.size()); ++i)
            result.error = std::max(result.error, matcher.error(here[i], there[i]));
        if (tally.all_right()) return;
        auto& first = tally.wrong_value > 0 ? result.first_changed : result.first_uncovered;
        if (!first) first = {place, here, there};
    });
    if (can_move && result.tally.missing > 0 && result.tally.extra > 0)
        result.moved = moved_primitives(yours, expected);
    for (const MovedPrimitive& one : result.moved) result.wrong_place += one.fragments;
    result.tally.missing -= result.wrong_place;
    result.tally.extra += yours.unplaced();
    result.tally.extra -= result.wrong_place;
    return result;
}

/// Says which expected row stands for a place: where nothing was expected, the first one of its primitive, if there is
/// any, and as well all others of it.
void set_row(const FragmentTable& expected, const Place& place, Fragments there, Difference& difference)
{
    const Fragments known = there.empty() ? expected.of(place.primitive) : there;
    if (known.empty()) return;
    difference.cell = known.front().row;
    if (there.empty())
        for (const auto& fragment : known.subspan(1)) difference.others.push_back(fragment.row);
}

std::string fragments_text(const FragmentTable& table, Fragments here, const FragmentWords& words, int digits)
{
    if (here.empty()) return "no " + words.row();
    if (here.size() > 1) return fmt::format("{} {}s", here.size(), words.row());
    std::vector<std::string> values;
    for (const double value : table.attributes(here[0])) values.push_back(number_text(value, digits));
    return values.empty() ? "one " + words.row() : fmt::format("({})", fmt::join(values, ", "));
}

/// The first place of the kind of fault that there is more of, and how it is called.
std::pair<const BadPlace*, const char*> first_of(const Comparison& result)
{
    const auto& [uncovered, changed] = std::tie(result.first_uncovered, result.first_changed);
    if (!uncovered || !changed) return {uncovered ? &*uncovered : changed ? &*changed : nullptr, "the first is"};
    const std::size_t all = result.tally.missing + result.tally.extra + result.tally.duplicated + result.wrong_place;
    if (all >= result.tally.wrong_value) return {&*uncovered, "the first that is missing or too much is"};
    return {&*changed, "the first with a wrong value is"};
}

std::string message(const Comparison& result, const FragmentTable& yours, const FragmentTable& expected,
                    const FragmentWords& words)
{
    std::vector<std::string> parts;
    const auto add = [&](std::size_t count, const char* what) {
        if (count > 0) parts.push_back(fmt::format("{} {}", count, what));
    };
    add(result.tally.missing, "missing");
    add(result.tally.extra, "extra");
    add(result.tally.duplicated, words.are_pixels() ? "drawn again" : "there again");
    add(result.tally.wrong_value, "with a wrong value");
    add(result.wrong_place, "in the wrong place");
    std::string text = fmt::format("{} of {} {}s are right; {}", result.tally.matched, expected.sorted().size(),
                                   words.row(), fmt::join(parts, ", "));
    if (!result.moved.empty()) text += "; " + moved_sentence(result.moved, words);
    if (yours.unplaced() > 0)
        text += fmt::format("; {} of yours lie at no pixel: primitive, x or y is no whole number", yours.unplaced());
    return text;
}

}

Judgement judge_fragments(const Check& check, const Tensor& student, const Tensor& expected_tensor, const Tensor* names,
                          bool with_sketch)
{
    const auto fault = [&](const char* what) { throw std::invalid_argument("check '" + check.name + "': " + what); };
    if (expected_tensor.components < 3) fault("fragments need rows of at least three numbers: primitive, x, y");
    const FragmentTable expected(expected_tensor);
    if (!all_finite(expected.view().values()) || expected.unplaced() > 0)
        fault("an expected fragment is not finite, or lies at no pixel");
    Tensor nothing = expected_tensor;
    nothing.rows = 0;
    nothing.bytes.clear();
    nothing.present.clear();
    const FragmentTable yours(student.cells() == 0 ? nothing : student);

    const FragmentMatcher matcher(check, yours, expected);
    const FragmentWords words(text_of(names));
    const Comparison result = compare(yours, expected, matcher, words.are_pixels());
    const FragmentTally& tally = result.tally;
    Judgement judgement;
    judgement.right = static_cast<double>(tally.matched) /
                      static_cast<double>(expected.sorted().size() + tally.extra + tally.duplicated);
    judgement.metrics = {{"fragments", static_cast<double>(expected.sorted().size())},
                         {"missing", static_cast<double>(tally.missing)},
                         {"extra", static_cast<double>(tally.extra)},
                         {"duplicated", static_cast<double>(tally.duplicated)},
                         {"wrong_value", static_cast<double>(tally.wrong_value)},
                         {"wrong_place", static_cast<double>(result.wrong_place)}};
    if (std::isfinite(result.error) && yours.unplaced() == 0) judgement.error = result.error;
    if (tally.all_right() && result.wrong_place == 0) return judgement;

    judgement.message = message(result, yours, expected, words);
    const auto [first, is_called] = first_of(result);
    if (first == nullptr) return judgement;
    const auto& [place, here, there] = *first;
    const auto [of_yours, of_expected] = telling_apart([&, here = here, there = there](int digits) {
        return std::pair(fragments_text(yours, here, words, digits), fragments_text(expected, there, words, digits));
    });
    judgement.first_difference = Difference{words.where(place), of_yours, of_expected};
    set_row(expected, place, there, *judgement.first_difference);
    judgement.message += fmt::format("; {} {}", is_called, judgement.first_difference->where);
    if (with_sketch && words.are_pixels()) judgement.sketch = fragment_sketch(matcher, yours, expected, place);
    return judgement;
}

}
