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

void add_evidence(Worker& worker, const Exercise& exercise, const CaseResults& cases, const GradeOptions& options,
                  const UnitResult& result, html::UnitDetail& unit)
{
    bool one_shown = false;
    int pictures = 0;
    // In the order in which a page shows them: where there are too many pictures, buffers come before colours.
    std::vector<std::size_t> order(exercise.checks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Hidden ones come last: what a student sees of the others must not depend on them.
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        return std::pair(exercise.checks[i].hidden, judge_of(exercise.checks[i]).place);
    });
    for (const std::size_t i : order) {
        const Check& check = exercise.checks[i];
        const CaseResult& one = cases.at(check.case_name);
        const bool right = result.checks[i].score >= check.points;
        if (is_picture(check) && pictures == most_pictures) continue;
        const bool of_interest = !right || (is_picture(check) && !one_shown && result.verdict == Verdict::ok);
        if (!of_interest || (check.hidden && !options.show_hidden) || !one.trouble().empty()) continue;
        const RunOutcome& expected = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
        const ExpectedSide side = expected_side(check, one.student, expected);
        const auto [value, margin, names] = expected_of(check, expected);
        const Observation observation{observed(check, one.student), side.tensor.get(), margin, names,
                                      result.checks[i].sketch};
        Evidence evidence = evidence_of(check, observation, right);
        if (auto* picture = std::get_if<PictureEvidence>(&evidence)) picture->expected_side = side.words;
        if (is_picture(check)) ++pictures;
        one_shown = one_shown || (right && !std::holds_alternative<std::monostate>(evidence));
        unit.checks[check.name].evidence = std::move(evidence);
    }
}

}
