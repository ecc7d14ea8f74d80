#include "model/manifest_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <umbral/record/wire.hpp>

namespace umbral::grader {
namespace {

constexpr std::string_view margin_suffix = ".margin";
constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 _.-";
constexpr int most_shift = 4096;
constexpr double most_scale = 1e6;

bool is_any_of(JudgeKind kind, std::initializer_list<JudgeKind> kinds) { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); }

std::array<int, 2> read_shift(const Field& field, JudgeKind judge)
{
    if (!is_any_of(judge, {JudgeKind::image, JudgeKind::buffer, JudgeKind::fragments}))
        field.refuse(fmt::format("no shift: what \"{}\" judges has no pixels to move (\"image\", \"buffer\" and \"fragments\" have)", to_string(judge)));
    const auto steps = field.items(2, 2);
    const std::array<int, 2> shift{steps[0].integer(-most_shift, most_shift), steps[1].integer(-most_shift, most_shift)};
    if (shift == std::array{0, 0}) field.refuse("[right, down] in whole pixels, not both 0");
    return shift;
}

double read_scale(const Field& field, JudgeKind judge)
{
    if (judge == JudgeKind::fragments) field.refuse("no scale: rows of \"fragments\" hold places, which no factor applies to");
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
    if (!is_any_of(check.judge, {JudgeKind::numbers, JudgeKind::matrices, JudgeKind::buffer, JudgeKind::image, JudgeKind::fragments}))
        field.refuse(fmt::format("no relation, since the judge is \"{}\"; \"numbers\", \"matrices\", \"buffer\", \"image\" and \"fragments\" can have one",
                                 to_string(check.judge)));
    if (check.hard) field.refuse("no relation, since the check is \"hard\": a relation compares the student's own values, and not the oracle's");
    field.allow_only({"to", "unlike", "shift", "scale", "what"});
    Relation relation;
    relation.to = read_recorded_name(field.member("to"));
    if (relation.to == check.value) field.member("to").refuse(fmt::format("another value of the case than the check's own, '{}'", check.value));
    if (const Field shift = field.member("shift"); shift.given()) relation.shift = read_shift(shift, check.judge);
    if (const Field scale = field.member("scale"); scale.given()) relation.scale = read_scale(scale, check.judge);
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
