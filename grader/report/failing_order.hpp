#pragma once

#include <tuple>

#include "judge/judges.hpp"
#include "model/scorecard.hpp"

namespace umbral::grader {

/// What failing checks are sorted by, the one that is to be looked at first in front: what is written and was run
/// before what is not; what is wrong itself before what is held back by another check; numbers, which have questions of
/// their own, before buffers, pictures and what is counted; the last digits of hard cases behind others of their kind;
/// what is nearly all right, as where it only passes a mistake on, behind what is not; and from exact to vague.
[[nodiscard]] inline auto failing_order(const CheckResult* check)
{
    const bool waits = check->unjudged == Unjudged::unwritten || check->unjudged == Unjudged::not_run;
    constexpr int first_vague = 2;  // JudgeRecord::place
    const int place = judge_of(*check).place;
    const bool nearly_right = 10 * check->score >= 9 * check->max_score;
    return std::tuple(waits, check->held_back, place >= first_vague, check->hard, nearly_right, place);
}

}
