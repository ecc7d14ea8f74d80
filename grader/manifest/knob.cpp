#include "manifest/knob.hpp"

#include <algorithm>

#include "judge/judges.hpp"

namespace umbral::grader {
std::optional<UnitKnob> read_unit_knob(const Field& field, const Exercise& exercise)
{
    if (!field.given()) return std::nullopt;
    field.allow_only({"name", "check", "case"});
    if (!exercise.is_cpp()) field.refuse("no knob: its curve is of solutions in C++");
    const UnitKnob knob{field.member("name").text(64), field.member("check").text(200), field.member("case").text(64)};
    const auto check = std::ranges::find(exercise.checks, knob.check, &Check::name);
    if (check == exercise.checks.end() || check->hidden || check->relation || judge_of(*check).rows == nullptr)
        field.member("check").refuse(
            "\"case/value\" of a visible check whose rows are compared one by one, and no relation");
    const auto of_the_case = [&](const Check& one) { return one.case_name == knob.case_name; };
    const auto hides = [&](const Check& one) { return of_the_case(one) && one.hidden; };
    if (std::ranges::none_of(exercise.checks, of_the_case) || std::ranges::any_of(exercise.checks, hides))
        field.member("case").refuse("a case of the unit's checks without hidden ones");
    return knob;
}

}
