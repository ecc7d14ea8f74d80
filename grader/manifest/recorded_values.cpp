#include "manifest/recorded_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <umbral/record/wire.hpp>

#include "judge/judges.hpp"
#include "text/joined.hpp"

namespace umbral::grader {
namespace {

constexpr std::string_view margin_suffix = ".margin";
constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 _.-";
constexpr int most_shift = 4096;
constexpr double most_scale = 1e6;

/// The judges for which `able` holds, as "\"image\", \"buffer\" and \"fragments\"".
template <class Able>
std::string judges_that(const Able& able)
{
    std::vector<std::string> names;
    for (const JudgeRecord* judge : judges())
        if (able(*judge)) names.push_back(fmt::format("\"{}\"", judge->name));
    return joined_with_and(names);
}

std::array<int, 2> read_shift(const Field& field, const JudgeRecord& judge)
{
    const auto able = [](const JudgeRecord& one) { return one.relation.moves; };
    if (!able(judge))
        field.refuse(
            fmt::format("no shift: what \"{}\" judges has no pixels to move ({} have)", judge.name, judges_that(able)));
    const auto steps = field.items(2, 2);
    const std::array<int, 2> shift{steps[0].integer(-most_shift, most_shift),
                                   steps[1].integer(-most_shift, most_shift)};
    if (shift == std::array{0, 0}) field.refuse("[right, down] in whole pixels, not both 0");
    return shift;
}

double read_scale(const Field& field, const JudgeRecord& judge)
{
    if (!judge.relation.scales)
        field.refuse(fmt::format("no scale: rows of \"{}\" hold places, which no factor applies to", judge.name));
    const double scale = field.number(0, most_scale);
    if (scale == 0 || scale == 1) field.refuse("a factor above 0 that is not 1");
    return scale;
}

}

std::string read_recorded_name(const Field& field)
{
    std::string name = field.text(wire::maximum_name - margin_suffix.size());
    if (name.find_first_not_of(letters) != std::string::npos || name.ends_with(margin_suffix))
        field.refuse("a recorded name in letters, digits and \" _.-\" that does not end in .margin");
    return name;
}

Relation read_relation(const Field& field, const Check& check)
{
    const JudgeRecord& judge = judge_of(check);
    const auto able = [](const JudgeRecord& one) { return one.relation.possible; };
    if (!able(judge))
        field.refuse(
            fmt::format("no relation, since the judge is \"{}\"; {} can have one", judge.name, judges_that(able)));
    if (check.hard)
        field.refuse(
            "no relation, since the check is \"hard\": a relation compares the student's own values, and not the "
            "oracle's");
    field.allow_only({"to", "unlike", "shift", "scale", "what"});
    Relation relation;
    relation.to = read_recorded_name(field.member("to"));
    if (relation.to == check.value)
        field.member("to").refuse(fmt::format("another value of the case than the check's own, '{}'", check.value));
    if (const Field shift = field.member("shift"); shift.given()) relation.shift = read_shift(shift, judge);
    if (const Field scale = field.member("scale"); scale.given()) relation.scale = read_scale(scale, judge);
    const Field unlike = field.member("unlike");
    if (unlike.given()) relation.unlike = read_recorded_name(unlike);
    if (unlike.given() && (relation.unlike == relation.to || relation.unlike == check.value))
        unlike.refuse(fmt::format("a third value of the case, neither '{}' nor '{}'", check.value, relation.to));
    if (!unlike.given() && !relation.moves() && !relation.scales())
        unlike.refuse("a value that must differ, since without shift and scale the same answer to everything would do");
    relation.what = field.member("what").text(200);
    if (relation.what.ends_with('.')) field.member("what").refuse("the law as a sentence without its full stop");
    return relation;
}

}
