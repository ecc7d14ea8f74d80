#include "question/possible_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "judge/rows/whole_number.hpp"
#include "question/bound_conditions.hpp"
#include "question/plain_conditions.hpp"

namespace umbral::grader {
namespace {

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

/// May one be less than the other for a reason? The others are so in the questions that there are, by chance.
bool measure_alike(const Fact& a, const Fact& b)
{
    const auto is_one = [&](Quantity quantity) { return (a.quantity == quantity ? 1 : 0) + (b.quantity == quantity); };
    // What is exactly one of these two.
    if (is_one(Quantity::angle) == 1 || is_one(Quantity::light) == 1) return false;
    if (is_one(Quantity::screen) == 1 && is_one(Quantity::depth) == 1) return false;
    const auto is_distance = [](const Fact& fact) { return fact.kind == Fact::Kind::length; };
    const auto is_size = [](const Fact& fact) { return fact.words.ends_with(".size()"); };
    // How far apart places are has nothing to do with how many there are, nor with pixels.
    for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
        if (is_distance(*one) && (is_size(*other) || other->quantity == Quantity::screen)) return false;
    // Nor do directions with places: the length of a direction is nothing.
    const bool are_vectors =
        is_distance(a) && is_distance(b) && a.words.starts_with("the length") && b.words.starts_with("the length");
    if (are_vectors && is_one(Quantity::direction) == 1) return false;
    // A number from a list of names has another quantity's size by chance, but for a list's length.
    return is_one(Quantity::index) != 1 || is_size(a) || is_size(b);
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
    if (!measure_alike(a, b)) return;
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
        add_bounds(facts, i, wrong, all);
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
