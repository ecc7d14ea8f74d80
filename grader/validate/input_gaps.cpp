#include "validate/input_gaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <set>
#include <string_view>

#include "question/facts.hpp"

namespace umbral::grader {
namespace {

using Numbers = std::vector<double>;

/// What comes in fewer calls than these hardly ever comes.
constexpr std::size_t enough_calls = 10;
constexpr std::size_t calls_for_one = 100;

/// "a.xyz" for "a.x", "a.y", "a.z" that follow each other.
void join_components(std::vector<std::string>& names)
{
    std::vector<std::string> joined;
    for (const std::string& name : names) {
        const std::size_t point = name.size() - 2;
        const bool is_component = name.size() > 2 && name[point] == '.' && std::strchr("yzw", name.back()) != nullptr;
        std::string* const last = joined.empty() ? nullptr : &joined.back();
        if (is_component && last != nullptr && last->size() > point && last->starts_with(name.substr(0, point + 1)) &&
            last->find_first_not_of("xyz", point + 1) == std::string::npos)
            *last += name.back();
        else
            joined.push_back(name);
    }
    names = std::move(joined);
}

/// Takes what is asked too seldom, and says it in few lines.
class Gaps {
public:
    explicit Gaps(const CallsOfFunction& calls) : calls_(calls)
    {
        for (const std::vector<Numbers>& run : calls.runs) all_ += run.size();
    }

    [[nodiscard]] const CallsOfFunction& calls() const noexcept { return calls_; }

    /// In how many calls is it so?
    [[nodiscard]] std::size_t count(const std::function<bool(const Numbers&)>& is_so) const
    {
        std::size_t found = 0;
        for (const std::vector<Numbers>& run : calls_.runs)
            found += static_cast<std::size_t>(std::ranges::count_if(run, is_so));
        return found;
    }

    /// In how many calls is it so beside the call before?
    [[nodiscard]] std::size_t count_pairs(const std::function<bool(const Numbers&, const Numbers&)>& is_so) const
    {
        std::size_t found = 0;
        for (const std::vector<Numbers>& run : calls_.runs)
            for (std::size_t i = 1; i < run.size(); ++i) found += is_so(run[i - 1], run[i]) ? 1 : 0;
        return found;
    }

    /// `what` is so in `found` calls.
    void add(const std::string& what, const std::string& where, std::size_t found)
    {
        if (found >= std::min(enough_calls, 1 + all_ / calls_for_one)) return;
        auto gap = std::ranges::find(gaps_, what, &InputGap::what);
        if (gap == gaps_.end()) gap = gaps_.insert(gaps_.end(), {what, {}});
        gap->where.push_back(found == 0 ? where : fmt::format("{} ({} of {})", where, found, all_));
    }

    void add_count(const std::string& what, std::size_t number, const std::function<bool(double)>& is_so)
    {
        add(what, calls_.numbers[number].name, count([&](const Numbers& call) { return is_so(call[number]); }));
    }

    [[nodiscard]] std::vector<InputGap> found() &&
    {
        for (InputGap& gap : gaps_) join_components(gap.where);
        return std::move(gaps_);
    }

private:
    const CallsOfFunction& calls_;
    std::size_t all_ = 0;
    std::vector<InputGap> gaps_;
};

bool is_so_of_any(const CallsOfFunction& calls, std::size_t number, const std::function<bool(double)>& is_so)
{
    return std::ranges::any_of(calls.runs, [&](const std::vector<Numbers>& run) {
        return std::ranges::any_of(run, [&](const Numbers& call) { return is_so(call[number]); });
    });
}

bool is_one_value(const CallsOfFunction& calls, std::size_t number)
{
    // input_gaps() is given a call at least.
    const double first = std::ranges::find_if_not(calls.runs, &std::vector<Numbers>::empty)->front()[number];
    return !is_so_of_any(calls, number, [&](double value) { return value != first; });
}

bool is_size(std::string_view name) { return name.ends_with(".size()"); }

/// "the number of steps of the wheel until then": a count of what came before, and not what the call is given.
bool is_count(const AskedNumber& number) { return number.name.starts_with("the number of "); }

void find_gaps_of_numbers(Gaps& gaps)
{
    const CallsOfFunction& calls = gaps.calls();
    for (std::size_t i = 0; i < calls.numbers.size(); ++i) {
        const AskedNumber& number = calls.numbers[i];
        if (number.is_of_whole_list || is_size(number.name) || is_count(number)) continue;
        if (is_one_value(calls, i)) {
            gaps.add("always the same", number.name, 0);
            continue;
        }
        if (number.is_word) continue;
        const auto between = [](double value) { return value > 0 && value < 1; };
        const auto is_broken = [](double value) { return value != std::trunc(value); };
        gaps.add_count("never 0", i, [](double value) { return value == 0; });
        gaps.add_count("never negative", i, [](double value) { return value < 0; });
        if (is_so_of_any(calls, i, is_broken)) gaps.add_count("never between 0 and 1", i, between);
        gaps.add_count("never broken", i, is_broken);
    }
}

void find_gaps_of_lists(Gaps& gaps)
{
    const CallsOfFunction& calls = gaps.calls();
    for (std::size_t i = 0; i < calls.numbers.size(); ++i) {
        const std::string& size = calls.numbers[i].name;
        if (!is_size(size)) continue;
        for (int length = 0; length < 4; ++length)
            gaps.add_count(fmt::format("never of {} elements", length), i,
                           [&](double value) { return value == length; });
        const std::string list = size.substr(0, size.find(".size()"));
        for (std::size_t k = 0; k < calls.numbers.size(); ++k)
            if (calls.numbers[k].name == "the number of different elements in " + list)
                gaps.add("never with equal elements", list,
                         gaps.count([&](const Numbers& call) { return call[k] < call[i]; }));
    }
}

void find_gaps_of_vectors(Gaps& gaps)
{
    std::vector<std::string> names;
    for (const AskedNumber& number : gaps.calls().numbers) names.push_back(number.name);
    const std::vector<VectorColumns> vectors = vectors_in(names);
    const auto part = [](const Numbers& call, const VectorColumns& vector) {
        return std::span(call).subspan(vector.first, vector.size);
    };
    for (const VectorColumns& vector : vectors) {
        if (vector.size < 3) continue;
        for (std::size_t k = 0; k < vector.size; ++k)
            gaps.add("never 0 beside others that are not", names[vector.first + k],
                     gaps.count([&](const Numbers& call) {
                         const auto numbers = part(call, vector);
                         return numbers[k] == 0 && std::ranges::count(numbers, 0) == 1;
                     }));
    }
    // Of one kind: two arguments, or the same part of two.
    const auto part_of = [](const std::string& words) { return words.substr(std::min(words.find('.'), words.size())); };
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (std::size_t j = i + 1; j < vectors.size(); ++j)
            if (vectors[i].size == vectors[j].size && part_of(vectors[i].words) == part_of(vectors[j].words))
                gaps.add("never equal", vectors[i].words + " = " + vectors[j].words,
                         gaps.count([&](const Numbers& call) {
                             return std::ranges::equal(part(call, vectors[i]), part(call, vectors[j]));
                         }));
}

/// "ray" of "ray.origin.x"; of a function with one argument "ray.origin".
std::string part_of(const AskedNumber& number, bool has_others)
{
    const std::string& name = number.name;
    if (number.is_of_whole_list) return name.substr(name.rfind(' ') + 1);
    const std::size_t point = name.find_first_of(".[");
    if (has_others || point == std::string::npos || is_size(name)) return name.substr(0, point);
    return name.substr(0, name.find_first_of(".[", point + 1));
}

/// Of code that keeps something from one call to the next.
void find_gaps_of_order(Gaps& gaps)
{
    const std::vector<AskedNumber>& numbers = gaps.calls().numbers;
    const bool has_several = numbers.front().argument != numbers.back().argument;
    std::vector<std::string> part;
    std::set<std::string> parts;
    for (const AskedNumber& number : numbers) {
        part.push_back(part_of(number, has_several));
        if (number.is_of_whole_list || !is_count(number)) parts.insert(part.back());
    }
    if (parts.size() < 2) return;
    for (const std::string& one : parts) {
        const auto is_same = [&](const Numbers& before, const Numbers& call, bool of_it) {
            for (std::size_t i = 0; i < call.size(); ++i)
                if ((part[i] == one) == of_it && before[i] != call[i]) return false;
            return true;
        };
        gaps.add("never the same as in the call before, beside others that differ", one,
                 gaps.count_pairs([&](const Numbers& before, const Numbers& call) {
                     return is_same(before, call, true) && !is_same(before, call, false);
                 }));
        gaps.add("never the only one that differs from the call before", one,
                 gaps.count_pairs([&](const Numbers& before, const Numbers& call) {
                     return !is_same(before, call, true) && is_same(before, call, false);
                 }));
    }
}

}

std::vector<InputGap> input_gaps(const CallsOfFunction& calls)
{
    if (std::ranges::all_of(calls.runs, &std::vector<Numbers>::empty) || calls.numbers.empty()) return {};
    Gaps gaps(calls);
    find_gaps_of_numbers(gaps);
    find_gaps_of_vectors(gaps);
    find_gaps_of_lists(gaps);
    find_gaps_of_order(gaps);
    return std::move(gaps).found();
}

}
