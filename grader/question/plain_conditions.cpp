#include "question/plain_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "judge/rows/whole_number.hpp"

namespace umbral::grader {
namespace {

constexpr double unit_rounding = 1e-5;  ///< of lengths of unit vectors, sines of parallel ones

PossibleCondition of_one(std::string words, std::size_t fact, int cost, bool (*test)(double))
{
    return {std::move(words),
            [fact, test](const std::vector<Fact>& facts, std::size_t i) { return test(facts[fact].values[i]); }, cost};
}

bool is_finite(double x) { return std::isfinite(x); }
bool is_minus_zero(double x) { return x == 0 && std::signbit(x); }

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
        // What a row is called says more than where it stands.
        const int cost = fact.label ? -1 : 0;
        add("is", true, cost);
        if (!two) add("is not", false, cost + 1);
    }
}

/// How many of the wrong ones differ in the whole numbers that are told of their questions, or of rows of a table in
/// anything, up to so many that it is enough: where a case has the same few shapes with every seed, any whole number of
/// one of these is its alone.
std::size_t different_among(const std::vector<Fact>& facts, const std::vector<bool>& wrong, bool are_rows)
{
    std::vector<const Fact*> looked_at;
    for (const Fact& fact : facts)
        if (are_rows || (!fact.answer && std::ranges::all_of(fact.values, is_whole_number))) looked_at.push_back(&fact);
    std::set<std::vector<double>> different;
    for (std::size_t i = 0; i < wrong.size() && different.size() < least_questions; ++i) {
        if (!wrong[i]) continue;
        std::vector<double> told;
        for (const Fact* const fact : looked_at)
            if (!std::isnan(fact->values[i])) told.push_back(fact->values[i]);
        different.insert(std::move(told));
    }
    return different.size();
}

/// Of a vector whose largest coordinates are as large as each other, without their signs: which of them is taken for
/// the largest is a rule.
void add_tie(const std::vector<Fact>& facts, std::size_t i, std::vector<PossibleCondition>& all)
{
    const std::string& words = facts[i].words;
    all.push_back(of_one("the largest coordinates of " + words + " are as large as each other", i, 2,
                         [](double ties) { return ties > 0; }));
    all.push_back(of_one("one coordinate of " + words + " is larger than the others", i, 4,
                         [](double ties) { return ties == 0; }));
}

}

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
        case Fact::Kind::tie: return 2;
        // Of a product that is 0, the vector that is 0 is the reason, where there is one.
        case Fact::Kind::product:
        case Fact::Kind::parallel:
        case Fact::Kind::size: break;
    }
    return 2;
}

bool is_extreme_of_list(const Fact& fact)
{
    return fact.words.starts_with("the least number") || fact.words.starts_with("the largest number");
}

bool is_length_of_lists(const Fact& fact)
{
    return fact.words.starts_with("the length of the shortest list") ||
           fact.words.starts_with("the length of the longest list");
}

void add_plain(const std::vector<Fact>& facts, std::size_t i, std::vector<PossibleCondition>& all)
{
    const Fact& fact = facts[i];
    if (!fact.value_names.empty()) return add_named(facts, i, all);
    if (fact.kind == Fact::Kind::tie) return add_tie(facts, i, all);
    if (fact.kind == Fact::Kind::size) return;
    const std::string& words = fact.words;
    const int cost = cost_of(fact);
    if (fact.kind == Fact::Kind::parallel) {
        // Of some it may be true up to a rounding only, which can be what matters.
        constexpr double rounding = 1e-15;
        const auto nearly = [&](auto is_so) { return std::ranges::any_of(fact.values, is_so) ? ", or nearly" : ""; };
        const std::string parallel = nearly([](double x) { return x > rounding && x < unit_rounding; });
        const std::string perpendicular =
            nearly([](double x) { return x > 1 - unit_rounding * unit_rounding && x < 1 - rounding; });
        all.push_back(of_one(words + " are parallel" + parallel, i, cost, [](double x) { return x < unit_rounding; }));
        all.push_back(of_one(words + " are not parallel", i, cost + 1, [](double x) { return x >= unit_rounding; }));
        all.push_back(of_one(words + " are perpendicular" + perpendicular, i, cost,
                             [](double x) { return x > 1 - unit_rounding * unit_rounding; }));
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
    all.push_back(of_one(words + " is 1", i, cost + 1, [](double x) { return std::abs(x - 1) < unit_rounding; }));
    all.push_back(
        of_one(words + " is not 1", i, cost + 1, [](double x) { return !(std::abs(x - 1) < unit_rounding); }));
    if (!std::ranges::all_of(fact.values, is_whole_number)) {
        // A length is one by chance, and a large float always.
        constexpr double whole_floats = 1U << 23U;
        const auto is_large = [](double x) { return std::isfinite(x) && std::abs(x) >= whole_floats; };
        if (fact.kind == Fact::Kind::length || std::ranges::any_of(fact.values, is_large)) return;
        const auto add = [&](const char* is, bool (*test)(double)) {
            all.push_back(of_one(words + is, i, cost + 5, test));
            // Very large floats are whole numbers: where one coordinate is, its size is the reason.
            all.back().accidental = fact.component;
        };
        add(" is a whole number", is_whole_number);
        add(" is no whole number", [](double x) { return !is_whole_number(x); });
        return;
    }
    if (!are_of_either_parity(fact.values)) return;
    all.push_back(of_one(words + " is odd", i, cost + 2, [](double x) { return std::fmod(std::abs(x), 2) == 1; }));
    all.push_back(of_one(words + " is even", i, cost + 2, [](double x) { return std::fmod(std::abs(x), 2) == 0; }));
}

void add_single_value(const std::vector<Fact>& facts, std::size_t i, const std::vector<bool>& wrong,
                      std::vector<PossibleCondition>& all)
{
    constexpr std::size_t least_values = 4;
    const Fact& fact = facts[i];
    const bool may_be = fact.kind == Fact::Kind::number && !fact.component && !fact.answer &&
                        fact.value_names.empty() && !is_extreme_of_list(fact);
    const auto first = std::ranges::find(wrong, true);
    if (!may_be || first == wrong.end()) return;
    const double value = fact.values[static_cast<std::size_t>(first - wrong.begin())];
    if (value == 0 || value == 1 || !std::ranges::all_of(fact.values, is_whole_number)) return;
    if (std::set(fact.values.begin(), fact.values.end()).size() < least_values) return;
    if (different_among(facts, wrong, fact.label) < least_questions) return;
    all.push_back({fmt::format("{} is {:.17g}", fact.words, value),
                   [i, value](const std::vector<Fact>& others, std::size_t question) {
                       return others[i].values[question] == value;
                   },
                   cost_of(fact) + 3});
}

}
