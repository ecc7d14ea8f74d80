#include "question/bound_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "judge/rows/whole_number.hpp"
#include "question/plain_conditions.hpp"
#include "question/rounded.hpp"
#include "question/size_facts.hpp"

namespace umbral::grader {
namespace {

/// Do these numbers differ by so much that their magnitudes say more than their differences?
bool are_magnitudes(double least, double largest) { return least > 0 && largest > 1e4 * least; }

/// A number of few digits strictly between two.
double between(double low, double high)
{
    const double middle = low == -std::numeric_limits<double>::infinity() ? high
                          : are_magnitudes(low, high)                     ? std::sqrt(low) * std::sqrt(high)
                                                                          : low + (high - low) / 2;
    for (int digits = 1; digits < 17; ++digits) {
        const double rounded = rounded_to(middle, digits);
        if (rounded > low && rounded <= high) return rounded;
    }
    return high;
}

/// Do so many of these values, which are different and in order, lie on either side of the first one from `bound` on,
/// and so near, that it says where wrong ones begin? Between few groups of equal numbers a bound can be put anywhere.
bool is_close(const std::vector<double>& values, double bound)
{
    constexpr std::ptrdiff_t least_whole = 2;  ///< of counts and sizes; of one, it is said that they are that one
    constexpr std::ptrdiff_t least = 4;
    constexpr double most_gap = 0.125;  ///< of what all values span
    const auto place = std::ranges::lower_bound(values, bound);
    const auto fewer = std::min(place - values.begin(), values.end() - place);
    if (std::ranges::all_of(values, is_whole_number)) return fewer >= least_whole;
    if (fewer < least) return false;
    const double below = *(place - 1);
    if (are_magnitudes(values.front(), values.back()))
        return std::log(*place / below) <= most_gap * std::log(values.back() / values.front());
    return *place - below <= most_gap * (values.back() - values.front());
}

/// Of questions whose fact is strictly between these two numbers.
auto lies_between(std::size_t fact, double low, double high)
{
    return [fact, low, high](const std::vector<Fact>& others, std::size_t question) {
        const double value = others[fact].values[question];
        return value > low && value < high;
    };
}

bool is_length(const Fact& fact) { return fact.kind == Fact::Kind::length || fact.kind == Fact::Kind::size; }

/// Is it 0 in some question that is answered right? What is wrong with small lengths may be right with none.
bool is_right_where_zero(const Fact& fact, const std::vector<bool>& wrong)
{
    for (std::size_t k = 0; k < wrong.size(); ++k)
        if (!wrong[k] && fact.values[k] == 0) return true;
    return false;
}

/// Where wrong answers lie on one side: "is less than 2", "is 7 or more". Of lengths also `but_zero`: "is above 0 and
/// less than 2".
void add_threshold(const std::vector<Fact>& facts, std::size_t i, const std::vector<bool>& wrong, bool but_zero,
                   std::vector<PossibleCondition>& all)
{
    const Fact& fact = facts[i];
    if (fact.kind == Fact::Kind::parallel || fact.kind == Fact::Kind::tie || !fact.value_names.empty()) return;
    if (but_zero && !(is_length(fact) && is_right_where_zero(fact, wrong))) return;
    struct Pair {
        double value;
        bool wrong;
    };
    std::vector<Pair> sorted;
    for (std::size_t k = 0; k < wrong.size(); ++k)
        if (std::isfinite(fact.values[k]) && !(but_zero && fact.values[k] == 0))
            sorted.push_back({fact.values[k], wrong[k]});
    if (sorted.size() < 2 * least_questions) return;
    std::ranges::sort(sorted, {}, &Pair::value);
    std::vector<double> values;
    for (const Pair& one : sorted)
        if (values.empty() || one.value != values.back()) values.push_back(one.value);
    std::size_t all_wrong = static_cast<std::size_t>(std::ranges::count(sorted, true, &Pair::wrong));
    std::size_t best = 0;
    std::size_t best_errors = sorted.size();
    bool best_below = false;
    std::size_t wrong_below = 0;
    for (std::size_t k = 1; k < sorted.size(); ++k) {
        wrong_below += sorted[k - 1].wrong ? 1 : 0;
        if (sorted[k].value == sorted[k - 1].value) continue;
        const std::size_t if_below = (k - wrong_below) + (all_wrong - wrong_below);
        const std::size_t if_above = sorted.size() - if_below;
        if (std::min(if_below, if_above) >= best_errors) continue;
        best = k;
        best_errors = std::min(if_below, if_above);
        best_below = if_below < if_above;
    }
    if (best == 0 || (but_zero && !best_below)) return;
    // Codes and counts: nothing lies between them, and what is right has no order that anybody thinks of.
    const bool whole = std::ranges::all_of(values, is_whole_number);
    const double bound = whole ? sorted[best].value : between(sorted[best - 1].value, sorted[best].value);
    // What needs no number is simpler, if it parts them as well.
    const int cost = std::max(cost_of(fact), 0) + 4;
    const char* const side = but_zero ? "above 0 and less than" : best_below ? "less than" : "at least";
    all.push_back({fmt::format("{} is {} {:.6g}", fact.words, side, bound),
                   [i, bound, best_below, but_zero](const std::vector<Fact>& others, std::size_t question) {
                       // What is not a number is neither.
                       const double value = others[i].values[question];
                       return best_below ? value < bound && !(but_zero && value == 0) : value >= bound;
                   },
                   cost, bound != 0});
    all.back().accidental = (whole && fact.answer) || !is_close(values, sorted[best].value);
    all.back().undecided = lies_between(i, sorted[best - 1].value, sorted[best].value);
}

/// Where wrong answers lie on both sides of the right ones: of lengths whose squares are too small for a number, or too
/// large. `low` and `high` are facts, the same or the lengths of the shortest and the longest vector, called `words`.
void add_range(const std::vector<Fact>& facts, std::size_t low, std::size_t high, const std::string& words,
               const std::vector<bool>& wrong, std::vector<PossibleCondition>& all)
{
    const auto is_told = [&](std::size_t k) {
        return std::isfinite(facts[low].values[k]) && std::isfinite(facts[high].values[k]);
    };
    const bool but_zero = is_right_where_zero(facts[low], wrong);
    const auto is_passed_over = [&](std::size_t k) { return !is_told(k) || (but_zero && facts[low].values[k] == 0); };
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double least_right = infinite;
    double largest_right = 0;
    for (std::size_t k = 0; k < wrong.size(); ++k) {
        if (wrong[k] || is_passed_over(k)) continue;
        least_right = std::min(least_right, facts[low].values[k]);
        largest_right = std::max(largest_right, facts[high].values[k]);
    }
    if (!are_magnitudes(least_right, largest_right)) return;
    constexpr std::size_t least_outside = 2;
    std::size_t below = 0;
    std::size_t above = 0;
    double largest_below = 0;
    double least_above = infinite;
    for (std::size_t k = 0; k < wrong.size(); ++k) {
        if (!wrong[k] || is_passed_over(k)) continue;
        if (facts[low].values[k] < least_right) {
            ++below;
            largest_below = std::max(largest_below, facts[low].values[k]);
        } else if (facts[high].values[k] > largest_right) {
            ++above;
            least_above = std::min(least_above, facts[high].values[k]);
        }
    }
    if (std::min(below, above) < least_outside) return;
    const double from = between(largest_below, least_right);
    const double to = between(largest_right, least_above);
    all.push_back(
        {fmt::format("{} is {}less than {:.6g} or at least {:.6g}", words, but_zero ? "above 0 and " : "", from, to),
         [low, high, from, to, but_zero](const std::vector<Fact>& others, std::size_t question) {
             const double value = others[low].values[question];
             return (value < from && !(but_zero && value == 0)) || others[high].values[question] >= to;
         },
         std::max(cost_of(facts[low]), 0) + 5, true});
    all.back().undecided = [below = lies_between(low, largest_below, least_right),
                            above = lies_between(high, largest_right, least_above)](const std::vector<Fact>& others,
                                                                                    std::size_t question) {
        return below(others, question) || above(others, question);
    };
}

/// The same of a length, and of the shortest and the longest of several vectors.
void add_ranges(const std::vector<Fact>& facts, std::size_t i, const std::vector<bool>& wrong,
                std::vector<PossibleCondition>& all)
{
    const Fact& fact = facts[i];
    if (fact.answer || !is_length(fact)) return;
    const bool is_shortest = fact.words.starts_with(length_of_shortest);
    if (!is_shortest) return add_range(facts, i, i, fact.words, wrong, all);
    if (i + 1 < facts.size() && facts[i + 1].words.starts_with(length_of_longest))
        add_range(facts, i, i + 1, "the length of one of " + fact.words.substr(length_of_shortest.size()), wrong, all);
}

}

void add_bounds(const std::vector<Fact>& facts, std::size_t i, const std::vector<bool>& wrong,
                std::vector<PossibleCondition>& all)
{
    for (const bool but_zero : {false, true}) add_threshold(facts, i, wrong, but_zero, all);
    add_ranges(facts, i, wrong, all);
}

}
