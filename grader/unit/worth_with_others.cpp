#include "unit/worth_with_others.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "judge/explain/likeness.hpp"
#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rules.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

/// What a picture has in common with the right one, at a glance, that is enough for all points.
constexpr double enough = 0.5;

/// What its outlines must have in common, in whatever colours: any blob in the middle has this much, which is worth
/// nothing, …
constexpr double outline_of_anything = 0.6;
/// … and a right one this.
constexpr double enough_outline = 0.9;

/// Calls that draw nothing of the right picture keep half: they are the right ones, and only what they are given is
/// not.
constexpr double least_of_calls = 0.5;

/// A picture of 1 where a pixel is not the background's, which the first one is, and 0 elsewhere.
Tensor outline(const Tensor& picture)
{
    const TensorView view(picture);
    Tensor inside{Element::uint8, picture.rows, picture.columns, 1, {}, {}};
    for (std::size_t i = 0; i < view.cells(); ++i)
        inside.bytes.push_back(std::byte{!std::ranges::equal(view.cell(i), view.cell(0))});
    return inside;
}

/// The share of a check's points that what hangs on it may earn: its own, or more if its picture has much in common
/// with the right one.
double share_of(Worker& worker, const Exercise& exercise, const Check& check, const CaseResult& one,
                const CheckResult& earned)
{
    const double share = static_cast<double>(earned.score) / static_cast<double>(check.points);
    if (share >= 1 || judge_of(check).look == Look::none || check.relation) return share;
    const RunOutcome& run = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
    const Tensor* const mine = observed(check, one.student);
    const Tensor* const right = expected_of(check, run).value;
    if (mine == nullptr || right == nullptr || !well_formed(*mine) || right->cells() == 0 ||
        shape_error(check, *mine, *right))
        return share;
    const double colours = likeness(check, *mine, *right).value_or(0) / enough;
    const double places = (likeness(check, outline(*mine), outline(*right)).value_or(0) - outline_of_anything) /
                          (enough_outline - outline_of_anything);
    return std::max(share, std::min(std::max(colours, places), 1.0));
}

/// The checks that this one hangs on, of which the best counts; none if it hangs on none.
std::vector<std::size_t> others_of(const Exercise& exercise, const Check& check)
{
    const auto find = [&](const auto& is_one) {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < exercise.checks.size(); ++i)
            if (is_one(exercise.checks[i])) found.push_back(i);
        return found;
    };
    if (!check.with.empty()) return find([&](const Check& other) { return other.name == check.with; });
    if (!judge_of(check).is_of_drawing) return {};
    const auto is_picture = [](const Check& other) { return judge_of(other).look == Look::colours && !other.relation; };
    const auto here = [&](const Check& other) { return is_picture(other) && other.case_name == check.case_name; };
    const std::vector<std::size_t> in_case = find(here);
    return in_case.empty() ? find(is_picture) : in_case;
}

/// Takes from a check what those that it hangs on, as they stand, do not bear.
void weigh(Worker& worker, const Exercise& exercise, const CaseResults& cases, std::size_t which, UnitResult& result)
{
    const Check& check = exercise.checks[which];
    CheckResult& earned = result.checks[which];
    const std::vector<std::size_t> others = others_of(exercise, check);
    double best = others.empty() ? 1 : check.with.empty() ? least_of_calls : 0;
    for (const std::size_t other : others) {
        const Check& that = exercise.checks[other];
        best = std::max(best, share_of(worker, exercise, that, cases.at(that.case_name), result.checks[other]));
    }
    const auto most = static_cast<Millipoints>(std::floor(static_cast<double>(check.points) * best));
    if (earned.score <= most) return;
    earned.held_back = earned.score == earned.max_score;
    earned.message +=
        fmt::format("{}{}: {} of {} points count", earned.message.empty() ? "" : "; ",
                    check.with.empty() ? "these calls draw too little of the right picture"
                                       : fmt::format("worth no more than \"{}\", which is not right", check.with),
                    points_text(most), points_text(check.points));
    earned.score = most;
}

}

void weigh_with_others(Worker& worker, const Exercise& exercise, const CaseResults& cases, UnitResult& result)
{
    // Calls hang on pictures, and other checks on either: so calls are weighed first.
    for (const bool named : {false, true})
        for (std::size_t i = 0; i < exercise.checks.size(); ++i)
            if (result.checks[i].score > 0 && exercise.checks[i].with.empty() != named)
                weigh(worker, exercise, cases, i, result);
}

}
