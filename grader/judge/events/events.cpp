#include "judge/events/events.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "judge/events/rule.hpp"
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

std::size_t significant(std::span<const double> event)
{
    std::size_t size = event.size();
    while (size > 1 && event[size - 1] == 0) --size;
    return size;
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
            for (std::size_t i = 0; i < expected.cells(); ++i)
                if (same_event(tolerance, event, expected.cell(i))) return came + " came too often";
            return came + " came, and is expected nowhere";
        }
    }
    const std::string instead =
        gap.surplus > 0 ? one_for_another(came, wanted) : fmt::format("expected {}, {} came", wanted, came);
    if (const auto place = later(parting, expected.cell(gap.expected), yours, gap.yours, yours_matched))
        return fmt::format("{}; it came too late, in row {} of yours", instead, *place);
    if (gap.surplus > 0) return instead;
    const auto times_in = [&](const TensorView& view) {
        std::size_t times = 0;
        for (std::size_t i = 0; i < view.cells(); ++i)
            if (same_event(tolerance, view.cell(i), expected.cell(gap.expected))) ++times;
        return times;
    };
    const std::size_t found = times_in(yours);
    const std::size_t sought = times_in(expected);
    return found == 0 || found >= sought
               ? instead
               : fmt::format("expected {}: {} of them in all, {} came", wanted, sought, found);
}

}

std::map<double, std::string> event_names(std::string_view lines)
{
    std::map<double, std::string> names;
    while (!lines.empty()) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(std::min(line.size() + 1, lines.size()));
        double code = 0;
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), code);
        const auto used = static_cast<std::size_t>(end - line.data());
        if (error == std::errc() && used + 1 < line.size() && line[used] == ' ') names[code] = line.substr(used + 1);
    }
    return names;
}

std::map<double, NamedRows> event_kinds(std::string_view lines, std::size_t components)
{
    std::map<double, NamedRows> kinds;
    for (const auto& [code, name] : event_names(lines)) {
        const std::size_t colon = std::min(name.find(": "), name.size());
        NamedRows& kind = kinds[code] = {name.substr(0, colon)};
        if (colon == name.size() || components == 0) continue;
        kind.columns = column_names(std::string_view(name).substr(colon + 2), components - 1, "");
        kind.columns.insert(kind.columns.begin(), "the kind of event");
        if (kind.columns.size() != components) kind.columns.clear();
    }
    return kinds;
}

std::vector<std::string> event_columns(std::string_view names, std::size_t components)
{
    std::vector<std::string> all;
    for (const auto& [code, kind] : event_kinds(names, components)) {
        if (kind.columns.empty()) continue;
        if (!all.empty() && kind.columns != all) return {};
        all = kind.columns;
    }
    return all;
}

EventWriter::EventWriter(const TensorView& expected, std::string_view names)
{
    for (auto& [code, name] : event_names(names)) {
        const std::size_t colon = name.find(": ");
        Kind& kind = kinds_[code] = {name, {}};
        if (colon == std::string::npos || expected.components() == 0) continue;
        kind.columns = column_groups(std::string_view(name).substr(colon + 2), expected.components() - 1);
        if (!kind.columns.empty()) kind.name.resize(colon);
    }
    for (std::size_t i = 0; i < expected.cells(); ++i)
        used_[expected.cell(i)[0]] = std::max(used_[expected.cell(i)[0]], significant(expected.cell(i)));
}

std::vector<std::string> EventWriter::parts(std::span<const double> event, int digits) const
{
    std::vector<std::string> all;
    const auto kind = kinds_.find(event[0]);
    if (kind != kinds_.end() && !kind->second.columns.empty()) {
        for (const ColumnGroup& group : kind->second.columns) {
            std::string& text = all.emplace_back(group.name);
            for (std::size_t i = 0; i < group.size; ++i) text += " " + number_text(event[1 + group.first + i], digits);
        }
        return all;
    }
    const auto used = used_.find(event[0]);
    const std::size_t size = std::max(significant(event), used == used_.end() ? 1 : used->second);
    for (std::size_t i = 1; i < size; ++i) all.push_back(number_text(event[i], digits));
    return all;
}

std::string EventWriter::with_parts(std::span<const double> event, const std::vector<std::string>& parts) const
{
    const auto kind = kinds_.find(event[0]);
    const std::string name =
        kind != kinds_.end() ? kind->second.name : fmt::format("event of code {}", number_text(event[0]));
    return parts.empty() ? name : fmt::format("{} ({})", name, fmt::join(parts, ", "));
}

std::string EventWriter::operator()(std::span<const double> event, int digits) const
{
    if (!std::isfinite(event[0])) return "an event whose code is no number";
    return with_parts(event, parts(event, digits));
}

std::pair<std::string, std::string> EventWriter::beside(std::span<const double> one, std::span<const double> other,
                                                        int digits) const
{
    constexpr std::size_t few = 4;
    const auto kind = kinds_.find(one[0]);
    const bool has_names = kind != kinds_.end() && kind->second.columns.size() > few;
    if (!has_names || one[0] != other[0]) return {(*this)(one, digits), (*this)(other, digits)};
    const std::vector<std::string> mine = parts(one, digits);
    const std::vector<std::string> its = parts(other, digits);
    std::vector<std::string> shown_mine;
    std::vector<std::string> shown_its;
    for (std::size_t i = 0; i < mine.size(); ++i) {
        const bool is_left_out = i > 0 && mine[i] == its[i];
        if (is_left_out && shown_mine.back() == "…") continue;
        shown_mine.push_back(is_left_out ? "…" : mine[i]);
        shown_its.push_back(is_left_out ? "…" : its[i]);
    }
    return {with_parts(one, shown_mine), with_parts(other, shown_its)};
}

Alignment align_events(const Check& check, const TensorView& a, const TensorView& b)
{
    const std::size_t size = std::min(a.cells(), 10 * b.cells() + 1000);
    Alignment alignment = align(size, b.cells(), [&](std::size_t i, std::size_t j) {
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

    const EventWriter write(expected, text_of(names));
    const auto [came, wanted] = telling_apart([&](int digits) {
        if (gap->surplus > 0 && gap->lost > 0)
            return write.beside(yours.cell(gap->yours), expected.cell(gap->expected), digits);
        return std::pair(gap->surplus > 0 ? write(yours.cell(gap->yours), digits) : "nothing",
                         gap->lost > 0 ? write(expected.cell(gap->expected), digits) : "nothing");
    });
    // What is only too much stands between two rows, and neither of their questions need have led to it.
    judgement.first_difference = Difference{fmt::format("row {} of {} events", gap->expected, expected.cells()), came,
                                            wanted, gap->lost > 0 ? std::optional(gap->expected) : std::nullopt};
    std::string counts = fmt::format("{} of {} expected events are right", matched, expected.cells());
    if (surplus > 0)
        counts += fmt::format("; {}{} that came {} not expected", alignment.best ? "" : "about ", surplus,
                              surplus == 1 ? "is" : "are");
    const std::string words = in_words({check.tolerance, yours, expected, alignment, *gap}, came, wanted);
    judgement.message = fmt::format("row {}: {} ({})", gap->expected, words, counts);
    if (words == one_for_another(came, wanted)) judgement.headline = counts;
    return judgement;
}

}
