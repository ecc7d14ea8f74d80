#include "unit/worth_of_calls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
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

/// 1 where a pixel is not the background's, which the first one is.
std::vector<double> outline(const Tensor& picture)
{
    const TensorView view(picture);
    std::vector<double> inside(view.cells());
    for (std::size_t i = 0; i < inside.size(); ++i)
        inside[i] = std::ranges::equal(view.cell(i), view.cell(0)) ? 0.0 : 1.0;
    return inside;
}

/// The correlation of two outlines; 0 where one of them is empty, or all there is.
double common_outline(const Tensor& a, const Tensor& b)
{
    const std::vector<double> mine = outline(a);
    const std::vector<double> other = outline(b);
    const auto count = static_cast<double>(mine.size());
    const double here = std::reduce(mine.begin(), mine.end()) / count;
    const double there = std::reduce(other.begin(), other.end()) / count;
    const double both = std::inner_product(mine.begin(), mine.end(), other.begin(), 0.0) / count;
    const double spread = std::sqrt(here * (1 - here) * there * (1 - there));
    return spread > 0 ? (both - here * there) / spread : 0.0;
}

/// What the student's picture has in common with the right one, 0 to 1.
double share_of_picture(Worker& worker, const Exercise& exercise, const Check& check, const CaseResult& one,
                        const CheckResult& earned)
{
    double share = static_cast<double>(earned.score) / static_cast<double>(check.points);
    const RunOutcome& run = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
    const Tensor* const mine = observed(check, one.student);
    const Tensor* const right = expected_of(check, run).value;
    if (mine == nullptr || right == nullptr || !well_formed(*mine) || right->cells() == 0 ||
        shape_error(check, *mine, *right))
        return share;
    share = std::max(share, likeness(check, *mine, *right).value_or(0));
    return std::max(share, common_outline(*mine, *right));
}

/// The largest share of a picture in the case of a check, or in the unit if its case has none; nothing if there is none
/// in the unit.
std::optional<double> picture_drawn(Worker& worker, const Exercise& exercise, const CaseResults& cases,
                                    const UnitResult& result, const std::string& case_name)
{
    std::optional<double> best;
    bool in_case = false;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        if (judge_of(check).look != Look::colours || check.relation) continue;
        const bool here = check.case_name == case_name;
        if (in_case && !here) continue;
        const double share = share_of_picture(worker, exercise, check, cases.at(check.case_name), result.checks[i]);
        best = here && !in_case ? share : std::max(best.value_or(0), share);
        in_case = in_case || here;
    }
    return best;
}

}

void weigh_calls(Worker& worker, const Exercise& exercise, const CaseResults& cases, UnitResult& result)
{
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        CheckResult& earned = result.checks[i];
        if (!judge_of(check).is_of_drawing || earned.score == 0) continue;
        const auto drawn = picture_drawn(worker, exercise, cases, result, check.case_name);
        if (!drawn || *drawn >= enough) continue;
        const auto most = static_cast<Millipoints>(std::floor(static_cast<double>(check.points) * *drawn / enough));
        if (earned.score <= most) continue;
        earned.message += fmt::format(
            "{}these calls draw {} of the right picture: {} of {} points count", earned.message.empty() ? "" : "; ",
            *drawn < enough / 5 ? "nothing" : "too little", points_text(most), points_text(check.points));
        earned.score = most;
    }
}

}
