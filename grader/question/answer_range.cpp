#include "question/answer_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "question/alike.hpp"
#include "question/wrong_numbers.hpp"

namespace umbral::grader {
namespace {

constexpr std::array lower_bounds{0.0, -1.0, 1.0};
constexpr std::array upper_bounds{1.0, 0.0, 255.0};
constexpr double clearly_beyond = 0.01;  ///< of the right ones' size

/// Numbers of all answers, of which the wrong ones are told apart.
struct Numbers {
    NumberPairs wrong{};
    std::vector<double> yours{};  ///< of all
    double size = 0;              ///< of the right ones
};

Numbers numbers_of(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong,
                   const std::vector<std::size_t>& which)
{
    Numbers numbers{numbers_in(wrong, table.components, which)};
    for (const AnswerPair& one : table.answers) {
        numbers.size = std::max(numbers.size, size_of(one.expected));
        for (std::size_t at = 0; at + table.components <= one.yours.size(); at += table.components)
            for (const std::size_t i : which) numbers.yours.push_back(one.yours[at + i]);
    }
    return numbers;
}

/// A bound on one side: `side` is 1 where answers are not larger than it, and -1 where they are not smaller.
struct Bound {
    double at;
    double side;
};

bool is_beyond(double number, const Bound& bound, double margin) { return bound.side * (number - bound.at) > margin; }

/// Does no answer pass the bound, though enough different right ones do, and does one lie at it?
bool is_kept(const Numbers& numbers, const Bound& bound)
{
    const double rest = rounding * std::max(std::abs(bound.at), of_floats * numbers.size);
    if (std::ranges::any_of(numbers.yours, [&](double x) { return is_beyond(x, bound, rest); })) return false;
    if (std::ranges::none_of(numbers.yours, [&](double x) { return std::abs(x - bound.at) <= rest; })) return false;
    std::set<double> beyond;
    for (const double right : numbers.wrong.right)
        if (is_beyond(right, bound, clearly_beyond * numbers.size)) beyond.insert(right);
    return beyond.size() >= least_wrong;
}

template <std::size_t Count>
std::optional<Bound> kept_bound(const Numbers& numbers, const std::array<double, Count>& bounds, double side)
{
    const auto found = std::ranges::find_if(bounds, [&](double at) { return is_kept(numbers, {at, side}); });
    return found == bounds.end() ? std::nullopt : std::optional(Bound{*found, side});
}

/// Is each wrong number the bound that its right one is beyond, or the right one itself?
bool are_cut(const NumberPairs& wrong, const std::optional<Bound>& lower, const std::optional<Bound>& upper)
{
    for (std::size_t i = 0; i < wrong.yours.size(); ++i) {
        const double right = wrong.right[i];
        double cut = lower ? std::max(right, lower->at) : right;
        if (upper) cut = std::min(cut, upper->at);
        if (!alike(wrong.yours[i], cut, std::max(std::abs(cut), of_floats * std::abs(right)))) return false;
    }
    return true;
}

}

std::optional<AnswerRange> range_of_answers(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong,
                                            const std::vector<std::size_t>& which)
{
    const Numbers numbers = numbers_of(table, wrong, which);
    const auto lower = kept_bound(numbers, lower_bounds, -1);
    const auto upper = kept_bound(numbers, upper_bounds, 1);
    if (!lower && !upper) return std::nullopt;
    if (lower && upper && lower->at >= upper->at) return std::nullopt;
    const bool cut = are_cut(numbers.wrong, lower, upper);
    const Bound& bound = lower ? *lower : *upper;
    std::string words;
    if (lower && upper)
        words = cut ? fmt::format("is the right one cut to {} to {}", lower->at, upper->at)
                    : fmt::format("is never below {} or above {}, though right ones are", lower->at, upper->at);
    else if (cut)
        words = fmt::format("is {} where the right one is {}", bound.at, lower ? "less" : "more");
    else
        words = fmt::format("is never {} {}, though right ones are", lower ? "below" : "above", bound.at);
    return AnswerRange{std::move(words), cut};
}

}
