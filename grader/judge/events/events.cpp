#include "judge/events/events.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "judge/events/partners.hpp"
#include "judge/events/rule.hpp"
#include "judge/rows/row_ranks.hpp"
#include "judge/rows/tolerance.hpp"

namespace umbral::grader {
namespace {

Scale scale_of(std::span<const double> numbers, std::size_t index)
{
    double largest = 0;
    for (const double value : numbers) largest = std::max(largest, std::abs(value));
    return {float_ulp(numbers[index]), largest};
}

// Two numbers that are both not finite went wrong in the same way: that matters between a student and a mistake, since
// no right answer has them.
bool same_number(const Tolerance& tolerance, std::span<const double> a, std::span<const double> b, std::size_t index)
{
    if (!std::isfinite(a[index]) || !std::isfinite(b[index])) return std::isfinite(a[index]) == std::isfinite(b[index]);
    return deviation(tolerance, a[index], b[index], scale_of(b, index)).right;
}

bool same_event(const Tolerance& tolerance, std::span<const double> a, std::span<const double> b)
{
    if (a[0] != b[0]) return false;
    for (std::size_t i = 1; i < b.size(); ++i)
        if (!same_number(tolerance, a.subspan(1), b.subspan(1), i - 1)) return false;
    return true;
}

/// Are two whole numbers only within the tolerance if they are equal?
bool parts_whole_numbers(const Tolerance& tolerance)
{
    return tolerance.absolute.value_or(0) < 1 && !tolerance.relative && !tolerance.ulps;
}

/// The first place where the sequences part: positions, and how many of each side stand there unmatched.
struct Gap {
    std::size_t yours = 0;
    std::size_t expected = 0;
    std::size_t surplus = 0;
    std::size_t lost = 0;
};

std::optional<Gap> first_gap(const Alignment& alignment, std::size_t yours, std::size_t expected)
{
    std::size_t next = 0;
    const auto gap = [&](std::size_t a, std::size_t b) { return Gap{next, next, a - next, b - next}; };
    for (const auto& [a, b] : alignment.matches) {
        if (a != next || b != next) return gap(a, b);
        ++next;
    }
    if (next == yours && next == expected) return std::nullopt;
    return gap(yours, expected);
}

/// Two sequences, and where they part.
struct Parting {
    const Tolerance& tolerance;
    const TensorView& yours;
    const TensorView& expected;
    const Alignment& alignment;
    const Gap& gap;
};

/// The first event of `side` behind `from` that has no partner and equals `event`.
template <class IsMatched>
std::optional<std::size_t> later(const Parting& parting, std::span<const double> event, const TensorView& side,
                                 std::size_t from, const IsMatched& matched)
{
    for (std::size_t i = from; i < side.cells(); ++i)
        if (!matched(i) && same_event(parting.tolerance, side.cell(i), event)) return i;
    return std::nullopt;
}

/// How often an event is one of a table's.
std::size_t times_in(const TensorView& view, std::span<const double> event, const Tolerance& tolerance)
{
    std::size_t times = 0;
    for (std::size_t i = 0; i < view.cells(); ++i)
        if (same_event(tolerance, view.cell(i), event)) ++times;
    return times;
}

std::string times_in_words(std::size_t times)
{
    return times == 1 ? "once" : times == 2 ? "twice" : fmt::format("{} times", times);
}

/// Where an event stands on one side only, and is known to the other: how often there and here, or in which row there.
/// "nothing" beside it would say that there is none.
void tell_where_else(const Parting& parting, std::string& came, std::string& wanted)
{
    const auto& [tolerance, yours, expected, alignment, gap] = parting;
    if ((gap.surplus > 0) == (gap.lost > 0)) return;
    const bool is_mine = gap.surplus > 0;
    const auto event = is_mine ? yours.cell(gap.yours) : expected.cell(gap.expected);
    const std::size_t mine = times_in(yours, event, tolerance);
    const std::size_t theirs = times_in(expected, event, tolerance);
    if (mine == 0 || theirs == 0) return;
    std::string& there = is_mine ? wanted : came;
    std::string& here = is_mine ? came : wanted;
    const TensorView& other = is_mine ? expected : yours;
    if (mine != theirs) {
        here += ", " + times_in_words(is_mine ? mine : theirs);
        there = "the same, " + times_in_words(is_mine ? theirs : mine);
        return;
    }
    for (std::size_t i = 0; i < other.cells(); ++i)
        if (same_event(tolerance, other.cell(i), event)) {
            there = fmt::format("the same in row {}", i);
            return;
        }
}

/// What came where another event is expected.
std::string one_for_another(const std::string& came, const std::string& wanted)
{
    return fmt::format("expected {}, {} came instead", wanted, came);
}

/// Too early, too late, too often, or another one altogether.
std::string in_words(const Parting& parting, const std::string& came, const std::string& wanted)
{
    const auto& [tolerance, yours, expected, alignment, gap] = parting;
    // Both sides of the matches increase.
    const auto yours_matched = [&](std::size_t i) {
        const auto found =
            std::ranges::lower_bound(alignment.matches, i, {}, &std::pair<std::size_t, std::size_t>::first);
        return found != alignment.matches.end() && found->first == i;
    };
    const auto expected_matched = [&](std::size_t i) {
        const auto found =
            std::ranges::lower_bound(alignment.matches, i, {}, &std::pair<std::size_t, std::size_t>::second);
        return found != alignment.matches.end() && found->second == i;
    };
    if (gap.surplus > 0) {
        const auto event = yours.cell(gap.yours);
        if (gap.lost == 0 && gap.yours > 0 && same_event(tolerance, event, yours.cell(gap.yours - 1)))
            return came + " came once more";
        if (const auto place = later(parting, event, expected, gap.expected, expected_matched))
            return fmt::format("{} came too early: it is expected in row {}{}", came, *place,
                               gap.lost > 0 ? ", after " + wanted : std::string());
        if (gap.lost == 0) {
            return came +
                   (times_in(expected, event, tolerance) > 0 ? " came too often" : " came, and is expected nowhere");
        }
    }
    const std::string instead =
        gap.surplus > 0 ? one_for_another(came, wanted) : fmt::format("expected {}, {} came", wanted, came);
    if (const auto place = later(parting, expected.cell(gap.expected), yours, gap.yours, yours_matched))
        return fmt::format("{}; it came too late, in row {} of yours", instead, *place);
    if (gap.surplus > 0) return instead;
    const std::size_t found = times_in(yours, expected.cell(gap.expected), tolerance);
    const std::size_t sought = times_in(expected, expected.cell(gap.expected), tolerance);
    return found == 0 || found >= sought
               ? instead
               : fmt::format("expected {}: {} of them in all, {} came", wanted, sought, found);
}

}

Alignment align_events(const Check& check, const TensorView& a, const TensorView& b)
{
    const std::size_t size = std::min(a.cells(), 10 * b.cells() + 1000);
    // Comparing numbers within a tolerance takes thirty times as long as comparing ranks.
    const auto ranks = parts_whole_numbers(check.tolerance) ? ranks_of_whole_rows(a, size, b) : std::nullopt;
    Alignment alignment = ranks ? align(*ranks) : align(size, b.cells(), [&](std::size_t i, std::size_t j) {
        return same_event(check.tolerance, a.cell(i), b.cell(j));
    });
    alignment.best = alignment.best && size == a.cells();
    return alignment;
}

Judgement judge_events(const Check& check, const Tensor& student, const Tensor& expected_tensor, const Tensor* names)
{
    const TensorView expected(expected_tensor);
    if (!all_finite(expected.values()))
        throw std::invalid_argument("check '" + check.name +
                                    "': an expected event is not finite, so nothing can match it");
    const TensorView yours(student);
    const Alignment alignment = align_events(check, yours, expected);
    const std::size_t matched = alignment.matches.size();
    const std::size_t lost = expected.cells() - matched;
    const std::size_t surplus = yours.cells() - matched;

    Judgement judgement;
    judgement.right = 2.0 * static_cast<double>(matched) / static_cast<double>(yours.cells() + expected.cells());
    judgement.metrics = {{"events", static_cast<double>(expected.cells())},
                         {"matched", static_cast<double>(matched)},
                         {"lost", static_cast<double>(lost)},
                         {"surplus", static_cast<double>(surplus)}};
    const std::optional<Gap> gap = first_gap(alignment, yours.cells(), expected.cells());
    if (!gap) return judgement;

    const Alignment wide = align_events(with_wide_bounds(check), yours, expected);
    judgement.clearly_wrong = yours.cells() + expected.cells() - 2 * wide.matches.size();
    const EventWriter write(expected, text_of(names));
    FirstApart shown;
    if (gap->surplus > 0) shown.yours = gap->yours;
    if (gap->lost > 0) shown.expected = gap->expected;
    const auto same = [&check](std::span<const double> a, std::span<const double> b) {
        return same_event(check.tolerance, a, b);
    };
    const std::optional<EventPair> meant = meant_pair(yours, expected, alignment, shown, same);
    if (meant) shown = {meant->yours, meant->expected};
    auto [came, wanted] = telling_apart([&](int digits) {
        if (shown.yours && shown.expected)
            return write.beside(yours.cell(*shown.yours), expected.cell(*shown.expected), digits);
        return std::pair(shown.yours ? write(yours.cell(*shown.yours), digits) : "nothing",
                         shown.expected ? write(expected.cell(*shown.expected), digits) : "nothing");
    });
    const Parting parting{check.tolerance, yours, expected, alignment, *gap};
    const std::string words = meant ? one_for_another(came, wanted) : in_words(parting, came, wanted);
    const bool is_instead = words == one_for_another(came, wanted);
    if (!meant) tell_where_else(parting, came, wanted);
    // What is only too much stands between two rows, and neither of their questions need have led to it.
    const std::size_t row = shown.expected.value_or(gap->expected);
    judgement.first_difference =
        Difference{fmt::format("row {} of {} events", row, expected.cells()), came, wanted, shown.expected};
    std::string counts = fmt::format("{} of {} expected events are right", matched, expected.cells());
    if (surplus > 0)
        counts += fmt::format("; {}{} that came {} not expected", alignment.best ? "" : "about ", surplus,
                              surplus == 1 ? "is" : "are");
    judgement.message = fmt::format("row {}: {} ({})", row, words, counts);
    if (is_instead) judgement.headline = counts;
    return judgement;
}

}
