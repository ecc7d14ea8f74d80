#pragma once

#include <algorithm>
#include <array>
#include <tuple>

#include "judge/judges.hpp"
#include "model/scorecard.hpp"

namespace umbral::grader {

/// How much there is to read of what was asked, from 0 on: a call of one line, of a few, a page; equal lengths are
/// nobody's concern. More than a page if its lists and calls had to be shortened ("… 297 more"), or if it is not known.
[[nodiscard]] inline int length_of_question(const CheckResult& check)
{
    constexpr std::array<std::size_t, 3> lengths{100, 250, 600};
    const bool known = check.first_difference && !check.first_difference->question.empty();
    const bool whole = known && check.first_difference->question.find("… ") == std::string::npos;
    if (!whole) return static_cast<int>(lengths.size()) + 1;
    const std::size_t size = check.first_difference->question.size();
    return static_cast<int>(std::ranges::lower_bound(lengths, size) - lengths.begin());
}

/// What failing checks are sorted by, the one that is to be looked at first in front: what is written and was run
/// before what is not; what is wrong itself before what is held back by another check; numbers, which have questions of
/// their own, before buffers, pictures and what is counted; the last digits of hard cases behind others of their kind;
/// short questions before long ones; of long ones what is nearly all right, as where it only passes a mistake on,
/// behind what is not; and from exact to vague.
[[nodiscard]] inline auto failing_order(const CheckResult* check)
{
    const bool waits = check->unjudged == Unjudged::unwritten || check->unjudged == Unjudged::not_run ||
                       check->unjudged == Unjudged::wrong_answers;
    constexpr int first_vague = 2;  // JudgeRecord::place
    const int place = judge_of(*check).place;
    const int length = length_of_question(*check);
    const bool nearly_right = length > 0 && 10 * check->score >= 9 * check->max_score;
    return std::tuple(waits, check->held_back, place >= first_vague, check->hard, length, nearly_right, place);
}

}
