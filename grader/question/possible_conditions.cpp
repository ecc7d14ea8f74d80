#include "question/possible_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "question/rounded.hpp"

namespace umbral::grader {
namespace {

constexpr double alike = 1e-5;  ///< of lengths of unit vectors, sines of parallel ones

PossibleCondition of_one(std::string words, std::size_t fact, int cost, bool (*test)(double))
{
    return {std::move(words),
            [fact, test](const std::vector<Fact>& facts, std::size_t i) { return test(facts[fact].values[i]); }, cost};
}

bool is_finite(double x) { return std::isfinite(x); }
bool is_integer(double x) { return std::isfinite(x) && x == std::round(x); }
bool is_minus_zero(double x) { return x == 0 && std::signbit(x); }

/// Of conditions that say the same, the one about the question's own numbers is said.
int cost_of(const Fact& fact)
{
    if (fact.first) return -1;
    // What was asked says more than what is right.
    if (fact.answer) return 5;
    if (fact.component) return 3;
    switch (fact.kind) {
        case Fact::Kind::number: return 0;
        case Fact::Kind::length: return 1;
        case Fact::Kind::coordinate: return 4;
        // Of a product that is 0, the vector that is 0 is the reason, where there is one.
        case Fact::Kind::product:
        case Fact::Kind::parallel: break;
    }
    return 2;
}

/// Are there several different odd numbers, and even ones? That one of few numbers is odd says nothing of oddness.
bool are_of_either_parity(const std::vector<double>& numbers)
{
    constexpr std::size_t least_different = 3;
    std::set<double> odd;
    std::set<double> even;
    for (const double x : numbers) (std::fmod(std::abs(x), 2) == 1 ? odd : even).insert(x);
    return std::min(odd.size(), even.size()) >= least_different;
}

/// Of a number that stands for a word: "rule is even_odd", "closed is true".
void add_named(const std::vector<Fact>& facts, std::size_t i, std::vector<PossibleCondition>& all)
{
    const Fact& fact = facts[i];
    const bool two = fact.value_names.size() == 2;
    for (std::size_t k = 0; k < fact.value_names.size(); ++k) {
        const double value = static_cast<double>(k);
        const auto add = [&](const char* is, bool equal, int cost) {
            all.push_back({fmt::format("{} {} {}", fact.words, is, fact.value_names[k]),
                           [i, value, equal](const std::vector<Fact>& others, std::size_t question) {
                               return (others[i].values[question] == value) == equal;
                           },
                           cost});
        };
        add("is", true, 0);
        if (!two) add("is not", false, 1);
    }
}

/// Is it the least or the largest number of a whole list? Whichever that is, it is hardly ever the reason.
bool is_extreme_of_list(const Fact& fact)
{
    return fact.words.starts_with("the least number") || fact.words.starts_with("the largest number");
}

/// Conditions that need no number: signs, zero, one, not finite.
void add_plain(const std::vector<Fact>& facts, std::size_t i, std::vector<PossibleCondition>& all)
{
    const Fact& fact = facts[i];
    if (!fact.value_names.empty()) return add_named(facts, i, all);
    const std::string& words = fact.words;
    const int cost = cost_of(fact);
    if (fact.kind == Fact::Kind::parallel) {
        // Of some it may be true up to a rounding only, which can be what matters.
        constexpr double rounding = 1e-15;
        const auto nearly = [&](auto is_so) { return std::ranges::any_of(fact.values, is_so) ? ", or nearly" : ""; };
        const std::string parallel = nearly([](double x) { return x > rounding && x < alike; });
        const std::string perpendicular = nearly([](double x) { return x > 1 - alike * alike && x < 1 - rounding; });
        all.push_back(of_one(words + " are parallel" + parallel, i, cost, [](double x) { return x < alike; }));
        all.push_back(of_one(words + " are not parallel", i, cost + 1, [](double x) { return x >= alike; }));
        all.push_back(of_one(words + " are perpendicular" + perpendicular, i, cost,
                             [](double x) { return x > 1 - alike * alike; }));
        return;
    }
    all.push_back(of_one(words + " is not finite", i, cost, [](double x) { return !is_finite(x); }));
    all.push_back(of_one(words + " is finite", i, cost + 1, is_finite));
    if (!is_extreme_of_list(fact)) {
        all.push_back(of_one(words + " is 0", i, cost, [](double x) { return x == 0; }));
        all.push_back(of_one(words + " is not 0", i, cost, [](double x) { return x != 0; }));
    }
    if (fact.kind == Fact::Kind::number) {
        all.push_back(of_one(words + " is -0", i, cost + 1, is_minus_zero));
        all.push_back(of_one(words + " is no number", i, cost + 1, [](double x) { return std::isnan(x); }));
        all.push_back(of_one(words + " is infinite", i, cost + 1, [](double x) { return std::isinf(x); }));
    }
    all.push_back(of_one(words + " is negative", i, cost, [](double x) { return x < 0; }));
    all.push_back(of_one(words + " is 0 or negative", i, cost + 1, [](double x) { return x <= 0; }));
    if (fact.kind == Fact::Kind::product) return;
    all.push_back(of_one(words + " is positive", i, cost, [](double x) { return x > 0; }));
    if (fact.kind == Fact::Kind::coordinate || is_extreme_of_list(fact)) return;
    all.push_back(of_one(words + " is 1", i, cost + 1, [](double x) { return std::abs(x - 1) < alike; }));
    all.push_back(of_one(words + " is not 1", i, cost + 1, [](double x) { return !(std::abs(x - 1) < alike); }));
    if (!std::ranges::all_of(fact.values, is_integer)) {
        const auto add = [&](const char* is, bool (*test)(double)) {
            all.push_back(of_one(words + is, i, cost + 5, test));
            // Very large floats are whole numbers: where one coordinate is, its size is the reason.
            all.back().accidental = fact.component;
        };
        add(" is a whole number", is_integer);
        add(" is no whole number", [](double x) { return !is_integer(x); });
        return;
    }
    if (!are_of_either_parity(fact.values)) return;
    all.push_back(of_one(words + " is odd", i, cost + 2, [](double x) { return std::fmod(std::abs(x), 2) == 1; }));
    all.push_back(of_one(words + " is even", i, cost + 2, [](double x) { return std::fmod(std::abs(x), 2) == 0; }));
}

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
    if (std::ranges::all_of(values, is_integer)) return fewer >= least_whole;
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
    if (fact.kind == Fact::Kind::parallel || !fact.value_names.empty()) return;
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
    const bool whole = std::ranges::all_of(values, is_integer);
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

/// "x" of "point.x".
std::string_view component_of(std::string_view words) { return words.substr(std::min(words.rfind('.'), words.size())); }

/// Of two facts that measure alike: "the distance between ray.origin and sphere.centre is less than sphere.radius".
void add_comparison(const std::vector<Fact>& facts, std::size_t i, std::size_t j, std::vector<PossibleCondition>& all)
{
    // A list's least number, or an answer's length, equals many a number by chance; so do different components.
    const bool same_component =
        facts[i].component && facts[j].component && component_of(facts[i].words) == component_of(facts[j].words);
    const auto comparable = [same_component](const Fact& fact) {
        if (is_extreme_of_list(fact) || fact.answer) return false;
        return fact.kind == Fact::Kind::length ||
               (fact.kind == Fact::Kind::number && (!fact.component || same_component));
    };
    // "The distance … is less than the radius" is how people say it.
    if (facts[i].kind == Fact::Kind::number && facts[j].kind == Fact::Kind::length) std::swap(i, j);
    const Fact& a = facts[i];
    const Fact& b = facts[j];
    if (!comparable(a) || !comparable(b) || a.value_names != b.value_names) return;
    if ((a.quantity == Quantity::angle) != (b.quantity == Quantity::angle)) return;
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
    if (a.value_names.empty()) {
        add(
            "less than", [](double x, double y) { return x < y; }, 0);
        add(
            "greater than", [](double x, double y) { return x > y; }, 0);
    }
    // Two that measure different things are equal by chance, where they are always the same number.
    if (a.value_names.empty() && !are_equal_often(a, b)) return;
    add(
        "equal to", [](double x, double y) { return x == y; }, 0);
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
        for (std::size_t k = before; k < all.size(); ++k) {
            all[k].of_answer = facts[i].answer;
            all[k].fact = i;
        }
        for (std::size_t j = i + 1; j < facts.size(); ++j) add_comparison(facts, i, j, all);
    }
    return all;
}

}
