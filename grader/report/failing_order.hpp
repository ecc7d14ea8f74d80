#pragma once

#include <tuple>

#include "judge/judges.hpp"
#include "model/scorecard.hpp"
#include "model/verdict.hpp"

namespace umbral::grader {

/// Nothing of the check could be judged, since it asks a function that is not written yet.
[[nodiscard]] inline bool is_unwritten(const CheckResult& check)
{
    return check.message == in_words(Verdict::not_implemented);
}

/// What failing checks are sorted by, the one that is to be looked at first in front: what is written before what is
/// not, the last digits of hard cases behind all else, and from exact to vague.
[[nodiscard]] inline auto failing_order(const CheckResult* check)
{
    return std::tuple(is_unwritten(*check), check->hard, judge_of(*check).place);
}

}
