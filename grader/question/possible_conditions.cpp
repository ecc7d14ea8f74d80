#include "question/possible_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "judge/rows/whole_number.hpp"
#include "question/plain_conditions.hpp"
#include "question/rounded.hpp"

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

/// Where wrong answers lie on one side: "is less than 2", "is 7 or more".
void add_threshold(const std::vector<Fact>& facts, std::size_t i, const std::vector<bool>& wrong,
                   std::vector<PossibleCondition>& all)
{
    const Fact& fact = facts[i];
    if (fact.kind == Fact::Kind::parallel || fact.kind == Fact::Kind::tie || !fact.value_names.empty()) return;
    struct Pair {
        double value;
        bool wrong;
    };
    std::vector<Pair> sorted;
    for (std::size_t k = 0; k < wrong.size(); ++k)
        if (std::isfinite(fact.values[k])) sorted.push_back({fact.values[k], wrong[k]});
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
    if (best == 0) return;
    // Codes and counts: nothing lies between them, and what is right has no order that anybody thinks of.
    const bool whole = std::ranges::all_of(values, is_whole_number);
    const double bound = whole ? sorted[best].value : between(sorted[best - 1].value, sorted[best].value);
    // What needs no number is simpler, if it parts them as well.
    const int cost = std::max(cost_of(fact), 0) + 4;
    all.push_back({fmt::format("{} is {} {:.6g}", fact.words, best_below ? "less than" : "at least", bound),
                   [i, bound, best_below](const std::vector<Fact>& others, std::size_t question) {
                       // What is not a number is neither.
                       const double value = others[i].values[question];
                       return best_below ? value < bound : value >= bound;
                   },
                   cost, bound != 0});
    all.back().accidental = (whole && fact.answer) || !is_close(values, sorted[best].value);
}

/// Are two facts equal to each other with several values?
bool are_equal_often(const Fact& a, const Fact& b)
{
    constexpr std::size_t least_values = 3;
    std::set<double> values;
    for (std::size_t i = 0; i < a.values.size() && values.size() < least_values; ++i)
        if (a.values[i] == b.values[i]) values.insert(a.values[i]);
    return values.size() >= least_values;
}

/// Of two counts: "framebuffer.x is no multiple of window.x", where the division of integers loses something.
void add_multiple(const std::vector<Fact>& facts, std::size_t i, std::size_t j, int cost,
                  std::vector<PossibleCondition>& all)
{
    constexpr std::size_t least_values = 3;
    const Fact& a = facts[i];
    const Fact& b = facts[j];
    if (a.kind != Fact::Kind::number || b.kind != Fact::Kind::number) return;
    // With few of either it is true by chance.
    std::set<std::pair<double, double>> multiples;
    std::set<std::pair<double, double>> others;
    for (std::size_t k = 0; k < a.values.size(); ++k) {
        const double x = a.values[k];
        const double y = b.values[k];
        if (!is_whole_number(x) || !is_whole_number(y) || x < 1 || y < 1) return;
        if (x != y) (std::fmod(x, y) == 0 ? multiples : others).emplace(x, y);
    }
    if (std::min(multiples.size(), others.size()) < least_values) return;
    all.push_back({fmt::format("{} is no multiple of {}", a.words, b.words),
                   [i, j](const std::vector<Fact>& told, std::size_t question) {
                       return std::fmod(told[i].values[question], told[j].values[question]) != 0;
                   },
                   cost});
    all.back().compares = true;
}

/// "x" of "point.x".
std::string_view component_of(std::string_view words) { return words.substr(std::min(words.rfind('.'), words.size())); }

/// Are wrong ones so with several pairs of values? Of two words, one pair alone says more: "enabled is true and writes
/// is true".
bool are_wrong_with_several(const Fact& a, const Fact& b, const std::vector<bool>& wrong, bool equal)
{
    std::set<std::pair<double, double>> pairs;
    for (std::size_t i = 0; i < wrong.size(); ++i)
        if (wrong[i] && (a.values[i] == b.values[i]) == equal) pairs.emplace(a.values[i], b.values[i]);
    return pairs.size() > 1;
}

/// Of two facts that measure alike: "the distance between ray.origin and sphere.centre is less than sphere.radius".
void add_comparison(const std::vector<Fact>& facts, std::size_t i, std::size_t j, const std::vector<bool>& wrong,
                    std::vector<PossibleCondition>& all)
{
    // A list's least number, or an answer's length, equals many a number by chance; so do different components.
    const bool same_component =
        facts[i].component && facts[j].component && component_of(facts[i].words) == component_of(facts[j].words);
    const auto comparable = [same_component](const Fact& fact) {
        if (is_extreme_of_list(fact) || is_length_of_lists(fact) || fact.answer) return false;
        return fact.kind == Fact::Kind::length ||
               (fact.kind == Fact::Kind::number && (!fact.component || same_component));
    };
    // "The distance … is less than the radius" is how people say it.
    if (facts[i].kind == Fact::Kind::number && facts[j].kind == Fact::Kind::length) std::swap(i, j);
    const Fact& a = facts[i];
    const Fact& b = facts[j];
    if (!comparable(a) || !comparable(b) || a.value_names != b.value_names) return;
    // How far apart places are has nothing to do with how many there are.
    if (a.kind == Fact::Kind::length && b.words.ends_with(".size()")) return;
    for (const Quantity one : {Quantity::angle, Quantity::light})
        if ((a.quantity == one) != (b.quantity == one)) return;
    // That a list has elements twice is a reason only if how long it is is none.
    const bool of_a_list = a.words.ends_with(".size()") && b.words.starts_with("the number of different");
    const int cost = 3 + (same_component || (a.kind == Fact::Kind::length && b.kind == Fact::Kind::length) ? 1 : 0) +
                     (of_a_list ? 2 : 0);
    const auto add = [&](const char* words, bool (*test)(double, double), int more) {
        all.push_back({fmt::format("{} is {} {}", a.words, words, b.words),
                       [i, j, test](const std::vector<Fact>& others, std::size_t question) {
                           return test(others[i].values[question], others[j].values[question]);
                       },
                       cost + more});
        all.back().compares = true;
    };
    const bool named = !a.value_names.empty();
    if (!named) {
        add(
            "less than", [](double x, double y) { return x < y; }, 0);
        add(
            "greater than", [](double x, double y) { return x > y; }, 0);
        add_multiple(facts, i, j, cost + 3, all);
        add_multiple(facts, j, i, cost + 3, all);
    }
    // Two that measure different things are equal by chance, where they are always the same number.
    if (!named && !are_equal_often(a, b)) return;
    if (!named || are_wrong_with_several(a, b, wrong, true))
        add(
            "equal to", [](double x, double y) { return x == y; }, 0);
    if (!named || are_wrong_with_several(a, b, wrong, false))
        add(
            "different from", [](double x, double y) { return x != y; }, 1);
}

}

std::vector<PossibleCondition> possible_conditions(const std::vector<Fact>& facts, const std::vector<bool>& wrong)
{
    std::vector<PossibleCondition> all;
    for (std::size_t i = 0; i < facts.size(); ++i) {
        const std::size_t before = all.size();
        add_plain(facts, i, all);
        add_threshold(facts, i, wrong, all);
        add_single_value(facts, i, wrong, all);
        for (std::size_t k = before; k < all.size(); ++k) {
            all[k].of_answer = facts[i].answer;
            all[k].fact = i;
        }
        for (std::size_t j = i + 1; j < facts.size(); ++j) add_comparison(facts, i, j, wrong, all);
    }
    return all;
}

}
