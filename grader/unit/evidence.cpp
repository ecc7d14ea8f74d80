#include "unit/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rows/tolerance.hpp"
#include "worker/related.hpp"

namespace umbral::grader {
namespace {

/// Of one unit: a fourth would show what the first three have shown. All of them lie in the folder of pictures.
constexpr int most_pictures = 3;

/// "4 ulp, or 1e-06 relative": every bound, since a value is right within any of them.
std::string bounds_in_words(const Tolerance& tolerance)
{
    std::string text;
    const auto add = [&](const std::optional<double>& bound, const char* unit) {
        if (bound) text += fmt::format("{}{:.6g}{}", text.empty() ? "" : ", or ", *bound, unit);
    };
    add(tolerance.ulps, " ulp");
    add(tolerance.relative, " relative");
    add(tolerance.absolute, " absolute");
    return text;
}

}

html::CheckDetail describe(const Check& check)
{
    html::CheckDetail detail;
    detail.why = check.why;
    detail.bound = bounds_in_words(check.tolerance);
    if (!has_bound(check.tolerance)) return detail;
    switch (unit_of(check.tolerance)) {
        case Unit::ulps: detail.limit = check.tolerance.ulps, detail.unit = "ulp"; break;
        case Unit::relative: detail.limit = check.tolerance.relative, detail.unit = "relative"; break;
        case Unit::absolute: detail.limit = check.tolerance.absolute; break;
    }
    return detail;
}

Evidence evidence_of(const Check& check, const Observation& observation, bool right)
{
    if (observation.yours == nullptr || observation.expected == nullptr) return {};
    if (!well_formed(*observation.yours) || !well_formed(*observation.expected)) return {};
    const auto make = judge_of(check).evidence;
    return make == nullptr ? Evidence{} : make(check, observation, right);
}

html::UnitDetail describe(const Exercise& exercise)
{
    html::UnitDetail unit;
    if (const auto english = exercise.title.find("en"); english != exercise.title.end()) unit.title = english->second;
    for (const Check& check : exercise.checks) unit.checks[check.name] = describe(check);
    return unit;
}

namespace {

/// The places of checks in the order in which a page shows them: where there are too many pictures, buffers come before
/// colours. Hidden ones come last: what a student sees of the others must not depend on them.
std::vector<std::size_t> page_order(const Exercise& exercise)
{
    std::vector<std::size_t> order(exercise.checks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        return std::pair(exercise.checks[i].hidden, judge_of(exercise.checks[i]).place);
    });
    return order;
}

/// What there is to see of a check in one run of its case.
Evidence seen_in(Worker& worker, const Exercise& exercise, const Check& check, const CaseResult& one,
                 const std::string& sketch, bool right)
{
    const RunOutcome& expected = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
    const ExpectedSide side = expected_side(check, one.student, expected);
    const auto [value, margin, names] = expected_of(check, expected);
    Evidence evidence =
        evidence_of(check, {observed(check, one.student), side.tensor.get(), margin, names, sketch}, right);
    if (auto* picture = std::get_if<PictureEvidence>(&evidence)) picture->expected_side = side.words;
    return evidence;
}

}

void add_evidence(Worker& worker, const Exercise& exercise, const CaseResults& cases, const CaseResults& practice,
                  const GradeOptions& options, const UnitResult& result, html::UnitDetail& unit)
{
    bool one_shown = false;
    int pictures = 0;
    int practice_shown = 0;
    for (const std::size_t i : page_order(exercise)) {
        const Check& check = exercise.checks[i];
        const CaseResult& one = cases.at(check.case_name);
        const bool right = result.checks[i].score >= check.points;
        if (check.hidden && is_picture(check) && !right && practice_shown < most_pictures)
            if (const auto drawn = practice.find(check.case_name); drawn != practice.end()) {
                unit.practice[check.name] = {.evidence = seen_in(worker, exercise, check, drawn->second, "", false),
                                             .practice = true};
                ++practice_shown;
            }
        if (is_picture(check) && pictures == most_pictures) continue;
        const bool of_interest = !right || (is_picture(check) && !one_shown && result.verdict == Verdict::ok);
        if (!of_interest || (check.hidden && !options.show_hidden) || !one.cause().empty()) continue;
        Evidence evidence = seen_in(worker, exercise, check, one, result.checks[i].sketch, right);
        if (is_picture(check)) ++pictures;
        one_shown = one_shown || (right && !std::holds_alternative<std::monostate>(evidence));
        unit.checks[check.name].evidence = std::move(evidence);
    }
}

}
