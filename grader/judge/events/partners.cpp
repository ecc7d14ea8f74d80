#include "judge/events/partners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace umbral::grader {
namespace {

constexpr std::size_t most_alone = 400;

using Event = std::span<const double>;
using Same = std::function<bool(Event, Event)>;
using Matches = std::vector<std::pair<std::size_t, std::size_t>>;

/// The events of a side that have no partner, as far as these are few enough.
std::vector<std::size_t> alone_in(std::size_t size, const Matches& matches, std::size_t Matches::value_type::*side)
{
    std::vector<std::size_t> alone;
    std::size_t next = 0;
    for (const auto& match : matches) {
        for (; next < match.*side; ++next) alone.push_back(next);
        ++next;
        if (alone.size() > most_alone) return {};
    }
    for (; next < size && alone.size() <= most_alone; ++next) alone.push_back(next);
    return alone.size() > most_alone ? std::vector<std::size_t>() : alone;
}

bool is_in(const TensorView& view, Event event, const Same& same)
{
    for (std::size_t i = 0; i < view.cells(); ++i)
        if (same(view.cell(i), event)) return true;
    return false;
}

bool are_rearranged(Event a, Event b) { return std::ranges::is_permutation(a.subspan(1), b.subspan(1)); }

/// How far apart two events of a kind are: numbers that differ, and by how much.
std::tuple<bool, std::size_t, double> apart(Event a, Event b)
{
    std::size_t different = 0;
    double sum = 0;
    for (std::size_t i = 1; i < b.size(); ++i) {
        if (a[i] == b[i]) continue;
        ++different;
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return {!are_rearranged(a, b), different, std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity()};
}

/// The event of `side` that is nearest to `event`, of those that stand alone and are not in `others`, which is looked
/// through only for events that are nearer than what was found.
std::optional<std::size_t> nearest(Event event, const TensorView& side, const std::vector<std::size_t>& alone,
                                   const TensorView& others, const Same& same)
{
    std::optional<std::size_t> best;
    for (const std::size_t i : alone) {
        const Event one = side.cell(i);
        if (one[0] != event[0] || (best && !(apart(one, event) < apart(side.cell(*best), event)))) continue;
        if (!is_in(others, one, same)) best = i;
    }
    return best;
}

}

std::optional<EventPair> meant_pair(const TensorView& yours, const TensorView& expected, const Alignment& alignment,
                                    const FirstApart& first, const Same& same)
{
    const Matches& matches = alignment.matches;
    if (first.yours) {
        const Event event = yours.cell(*first.yours);
        if (is_in(expected, event, same)) return std::nullopt;
        const auto alone = alone_in(expected.cells(), matches, &Matches::value_type::second);
        const auto meant = nearest(event, expected, alone, yours, same);
        if (!meant || meant == first.expected) return std::nullopt;
        // What stands beside it is what was expected there, unless another one is plainly the one that was meant.
        if (first.expected &&
            (!are_rearranged(event, expected.cell(*meant)) || are_rearranged(event, expected.cell(*first.expected))))
            return std::nullopt;
        return EventPair{*first.yours, *meant};
    }
    if (!first.expected) return std::nullopt;
    const Event event = expected.cell(*first.expected);
    if (is_in(yours, event, same)) return std::nullopt;
    const auto alone = alone_in(yours.cells(), matches, &Matches::value_type::first);
    const auto meant = nearest(event, yours, alone, expected, same);
    return meant ? std::optional(EventPair{*meant, *first.expected}) : std::nullopt;
}

}
