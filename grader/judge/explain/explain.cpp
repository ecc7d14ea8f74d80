#include "judge/explain/explain.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "judge/explain/resemblances.hpp"
#include "judge/explain/thresholds.hpp"
#include "judge/explain/transforms.hpp"
#include "judge/judges.hpp"
#include "judge/rows/rows.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rules.hpp"

namespace umbral::grader {
namespace {

bool comparable(const FailingCheck& failing)
{
    return failing.check != nullptr && failing.student != nullptr && failing.expected != nullptr &&
           well_formed(*failing.expected) && failing.expected->cells() > 0 &&
           !shape_error(*failing.check, *failing.student, *failing.expected);
}

// Undoing rounds again, so bounds are widened to what a few float operations lose; the result as it came must fail
// these too.
Check widened(Check check)
{
    Tolerance& tolerance = check.tolerance;
    // However much a check forgives, what is named must be seen.
    if (has_bound(tolerance)) tolerance.relative = std::clamp(4 * tolerance.relative.value_or(0), 1e-5, 1e-2);
    if (tolerance.absolute) tolerance.absolute = std::min(4 * *tolerance.absolute, std::max(*tolerance.absolute, 0.5));
    if (tolerance.ulps) tolerance.ulps = 4 * *tolerance.ulps;
    if (judge_of(check).look == Look::values && !has_bound(tolerance)) tolerance.relative = 1e-5;
    return check;
}

bool raises(double before, double after, double full)
{
    return after >= full || (after >= thresholds::explained && before <= thresholds::unexplained_share * after);
}

/// Rows that `states` calls wrong, for which `others` says something else.
std::vector<bool> mended_rows(const std::vector<RowState>& before, const std::vector<RowState>& after)
{
    std::vector<bool> mended(before.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        mended[i] = before[i] == RowState::wrong && after[i] == RowState::right;
    return mended;
}

/// How much it says that `undone` is right where the student was wrong.
double mending_bits(const Check& check, const FailingCheck& one, const Tensor& undone)
{
    const std::size_t cells = one.expected->cells();
    if (judge_of(check).look == Look::colours)
        return agreement_bits(*one.student, *one.expected, std::vector<bool>(cells, true),
                              different_pixels(check, *one.student, *one.expected));
    Check rows = check;
    rows.pairs = false;
    const Tensor expected = made_finite(*one.expected);
    const auto before = row_states(rows, *one.student, expected, one.margin, rows_of(check));
    const auto after = row_states(rows, undone, expected, one.margin, rows_of(check));
    return agreement_bits(*one.student, *one.expected, counted(before), mended_rows(before, after));
}

/// Nothing if the transform cannot be tried: it is none of such values, or would be fitted to one or two of them.
std::optional<Resemblance> says_of(const NamedTransform& transform, const Check& check, const FailingCheck& one,
                                   double before)
{
    if (!one.fails && transform.fitted_bits > 0) return Resemblance{};
    const auto undone = transform.undo(check, *one.student, *one.expected);
    if (!undone) return std::nullopt;
    if (*undone == *one.student) return one.fails ? not_alike : Resemblance{};
    const double after = fraction_right(check, *undone, *one.expected, one.margin);
    if (!one.fails) return after < check.full ? not_alike : Resemblance{};
    if (raises(before, after, check.full))
        return Resemblance{Says::for_it, std::max(0.0, mending_bits(check, one, *undone) - transform.fitted_bits)};
    // Where next to all of the error is gone, what is left may be what undoing lost in rounding: hard cases ask for the
    // last digits.
    const bool nearly =
        distance(*undone, *one.expected) <= thresholds::rounding_left * distance(*one.student, *one.expected);
    return nearly ? Resemblance{} : not_alike;
}

/// What the checks say of one transform.
struct Trial {
    Tally tally;
    std::set<JudgeKind> mended;                  ///< kinds of checks that speak for it
    std::map<JudgeKind, std::size_t> not_tried;  ///< failing checks on which it could not be tried

    /// Checks of another kind are no witnesses: a picture does not tell that the numbers behind it were scaled. Those
    /// of the same kind are.
    [[nodiscard]] Tally all() const
    {
        Tally result = tally;
        for (const auto& [kind, count] : not_tried)
            if (mended.contains(kind)) result.against_it += count;
        return result;
    }
};

}

const std::vector<NamedTransform>& named_transforms()
{
    static const std::vector<NamedTransform> all = [] {
        std::vector<NamedTransform> list;
        for (const JudgeRecord* judge : judges())
            if (judge->transforms != nullptr)
                for (NamedTransform& transform : judge->transforms()) list.push_back(std::move(transform));
        return list;
    }();
    return all;
}

std::vector<Explanation> explain_by_transform(const std::vector<FailingCheck>& checks)
{
    const std::vector<NamedTransform>& transforms = named_transforms();
    std::vector<Explanation> explanations;
    std::vector<Trial> trials(transforms.size());
    for (const NamedTransform& transform : transforms) explanations.push_back({transform.name, transform.sentence, 0});
    std::set<std::string> failing_values;
    for (const FailingCheck& one : checks)
        if (one.check != nullptr && one.fails) failing_values.insert(one.check->value);
    for (const FailingCheck& one : checks) {
        if (one.check == nullptr || (!one.fails && !failing_values.contains(one.check->value))) continue;
        const JudgeKind kind = one.check->judge;
        const bool can_be_tried = comparable(one) && !judge_of(kind).free_rows;
        const Check check = widened(*one.check);
        const double before = can_be_tried ? fraction_right(check, *one.student, *one.expected, one.margin) : 0;
        for (std::size_t i = 0; i < transforms.size(); ++i) {
            std::optional<Resemblance> said;
            // Too little of an error to tell what it is: rounding, to the wider tolerance.
            if (can_be_tried && one.fails && before >= check.full)
                said = not_alike;
            else if (can_be_tried)
                said = says_of(transforms[i], check, one, before);
            if (!said && one.fails) ++trials[i].not_tried[kind];
            if (!said) continue;
            if (said->says == Says::for_it && trials[i].tally.for_it == 0 && transforms[i].describe != nullptr)
                if (std::string sentence = transforms[i].describe(check, *one.student, *one.expected);
                    !sentence.empty())
                    explanations[i].sentence = std::move(sentence);
            if (said->says == Says::for_it) trials[i].mended.insert(kind);
            trials[i].tally += *said;
        }
    }
    for (std::size_t i = 0; i < explanations.size(); ++i) {
        explanations[i].confidence = confidence(trials[i].all());
        explanations[i].fit = fit(trials[i].all());
    }
    std::erase_if(explanations, [](const Explanation& explanation) { return explanation.confidence == 0; });
    std::ranges::stable_sort(explanations, std::ranges::greater{}, &Explanation::confidence);
    return explanations;
}

namespace {

/// Neither can be judged, because of its type or size: then only equality tells, as much as two numbers do (how many
/// rows, and what they hold).
Resemblance same_misfit(const FailingCheck& failing, const Tensor& mistake)
{
    constexpr double bits = 12;
    if (failing.student == nullptr || !(*failing.student == mistake)) return not_alike;
    return {Says::for_it, mistake.cells() == 0 ? 0 : bits};
}

}

Resemblance resemblance(const FailingCheck& one, const Tensor& mistake)
{
    if (one.check == nullptr || one.expected == nullptr || !well_formed(*one.expected) || one.expected->cells() == 0)
        return {};
    const bool judged = !shape_error(*one.check, mistake, *one.expected);
    if (!one.fails) {
        // By its points, as the student's passed: a few cells of a large buffer round away.
        const bool passes =
            judged && points_for(*one.check, fraction_right(*one.check, mistake, *one.expected, one.margin), 0) ==
                          one.check->points;
        return passes ? Resemblance{} : not_alike;
    }
    if (!judged && !comparable(one)) return same_misfit(one, mistake);
    if (!judged || !comparable(one)) return not_alike;
    const auto resembles = judge_of(*one.check).resemblance;
    return resembles != nullptr ? resembles(one, mistake) : not_alike;
}

}
