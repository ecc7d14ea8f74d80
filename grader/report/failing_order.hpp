#pragma once

#include <tuple>

#include "judge/judges.hpp"
#include "model/scorecard.hpp"

namespace umbral::grader {

/// What failing checks are sorted by, the one that is to be looked at first in front: what is written and was run
/// before what is not, the last digits of hard cases behind all else, and from exact to vague.
[[nodiscard]] inline auto failing_order(const CheckResult* check)
{
    const bool waits = check->unjudged == Unjudged::unwritten || check->unjudged == Unjudged::not_run;
    return std::tuple(waits, check->hard, judge_of(*check).place);
}

}
