#include "question/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbral::grader {
namespace {

constexpr std::size_t least_questions = 4;
constexpr double alike = 1e-5;  ///< of lengths of unit vectors, sines of parallel ones

using Test = std::function<bool(const std::vector<Fact>&, std::size_t)>;

struct Candidate {
    std::string words;
    Test holds;
    int cost = 0;            ///< how far-fetched: of several that part alike, the cheapest is said
    bool fitted = false;     ///< as in Condition
    bool of_answer = false;  ///< likewise
};

Candidate of_one(std::string words, std::size_t fact, int cost, bool (*test)(double))
{
    return {std::move(words),
            [fact, test](const std::vector<Fact>& facts, std::size_t i) { return test(facts[fact].values[i]); }, cost};
}

bool is_finite(double x) { return std::isfinite(x); }

/// Of a number that stands for a word: "rule is even_odd", "closed is true".
void add_named(const std::vector<Fact>& facts, std::size_t i, std::vector<Candidate>& all)
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

/// Conditions that need no number: signs, zero, one, not finite.
void add_plain(const std::vector<Fact>& facts, std::size_t i, std::vector<Candidate>& all)
{
    const Fact& fact = facts[i];
    if (!fact.value_names.empty()) return add_named(facts, i, all);
    const std::string& words = fact.words;
    // Of a product that is 0, the vector that is 0 is the reason, where there is one.
    const bool plain = fact.kind == Fact::Kind::number;
    const int cost = fact.first ? -1 : fact.component ? 3 : plain ? 0 : fact.kind == Fact::Kind::length ? 1 : 2;
    if (fact.kind == Fact::Kind::parallel) {
        all.push_back(of_one(words + " are parallel", i, cost, [](double x) { return x < alike; }));
        all.push_back(of_one(words + " are not parallel", i, cost + 1, [](double x) { return x >= alike; }));
        all.push_back(of_one(words + " are perpendicular", i, cost, [](double x) { return x > 1 - alike * alike; }));
        return;
    }
    all.push_back(of_one(words + " is not finite", i, cost, [](double x) { return !is_finite(x); }));
    all.push_back(of_one(words + " is finite", i, cost + 1, is_finite));
    all.push_back(of_one(words + " is 0", i, cost, [](double x) { return x == 0; }));
    all.push_back(of_one(words + " is not 0", i, cost, [](double x) { return x != 0; }));
    all.push_back(of_one(words + " is negative", i, cost, [](double x) { return x < 0; }));
    all.push_back(of_one(words + " is 0 or negative", i, cost + 1, [](double x) { return x <= 0; }));
    if (fact.kind == Fact::Kind::product) return;
    all.push_back(of_one(words + " is positive", i, cost, [](double x) { return x > 0; }));
    all.push_back(of_one(words + " is 1", i, cost + 1, [](double x) { return std::abs(x - 1) < alike; }));
    all.push_back(of_one(words + " is not 1", i, cost + 1, [](double x) { return !(std::abs(x - 1) < alike); }));
    const bool whole =
        std::ranges::all_of(fact.values, [](double x) { return std::isfinite(x) && x == std::round(x); });
    if (!whole) return;
    all.push_back(of_one(words + " is odd", i, cost + 2, [](double x) { return std::fmod(std::abs(x), 2) == 1; }));
    all.push_back(of_one(words + " is even", i, cost + 2, [](double x) { return std::fmod(std::abs(x), 2) == 0; }));
}

/// A number of few digits strictly between two.
double between(double low, double high)
{
    for (int digits = 1; digits < 17; ++digits) {
        const double middle = low == -std::numeric_limits<double>::infinity() ? high : low + (high - low) / 2;
        const double rounded = std::stod(fmt::format("{:.{}g}", middle, digits));
        if (rounded > low && rounded <= high) return rounded;
    }
    return high;
}

/// Where wrong answers lie on one side: "is less than 2", "is 7 or more".
void add_threshold(const std::vector<Fact>& facts, std::size_t i, const std::vector<bool>& wrong,
                   std::vector<Candidate>& all)
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
    const double bound = between(sorted[best - 1].value, sorted[best].value);
    const int cost = (fact.component ? 5 : 4) + (fact.kind == Fact::Kind::number ? 0 : 1);
    all.push_back({fmt::format("{} is {} {:.6g}", fact.words, best_below ? "less than" : "at least", bound),
                   [i, bound, best_below](const std::vector<Fact>& others, std::size_t question) {
                       // What is not a number is neither.
                       const double value = others[i].values[question];
                       return best_below ? value < bound : value >= bound;
                   },
                   cost, bound != 0});
}

/// Of two facts that measure alike: "the distance between ray.origin and sphere.centre is less than sphere.radius".
void add_comparison(const std::vector<Fact>& facts, std::size_t i, std::size_t j, std::vector<Candidate>& all)
{
    // A list's least number, or an answer's length, equals many a number by chance.
    const auto comparable = [](const Fact& fact) {
        if (fact.words.starts_with("the least") || fact.words.starts_with("the largest") || fact.answer) return false;
        return fact.kind == Fact::Kind::length || (fact.kind == Fact::Kind::number && !fact.component);
    };
    // "The distance … is less than the radius" is how people say it.
    if (facts[i].kind == Fact::Kind::number && facts[j].kind == Fact::Kind::length) std::swap(i, j);
    const Fact& a = facts[i];
    const Fact& b = facts[j];
    if (!comparable(a) || !comparable(b) || a.value_names != b.value_names) return;
    const int cost = 3 + (a.kind == Fact::Kind::length && b.kind == Fact::Kind::length ? 1 : 0);
    const auto add = [&](const char* words, bool (*test)(double, double), int more) {
        all.push_back({fmt::format("{} is {} {}", a.words, words, b.words),
                       [i, j, test](const std::vector<Fact>& others, std::size_t question) {
                           return test(others[i].values[question], others[j].values[question]);
                       },
                       cost + more});
    };
    if (a.value_names.empty()) {
        add(
            "less than", [](double x, double y) { return x < y; }, 0);
        add(
            "greater than", [](double x, double y) { return x > y; }, 0);
    }
    add(
        "equal to", [](double x, double y) { return x == y; }, 0);
    add(
        "different from", [](double x, double y) { return x != y; }, 1);
}

Condition measured(const Candidate& candidate, const std::vector<Fact>& facts, const std::vector<bool>& wrong)
{
    Condition condition{candidate.words, candidate.holds, candidate.fitted, candidate.of_answer};
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        const bool holds = candidate.holds(facts, i);
        ++(wrong[i] ? condition.wrong : condition.right);
        if (holds) ++(wrong[i] ? condition.wrong_where : condition.right_where);
    }
    return condition;
}

bool parted(const Condition& one)
{
    return static_cast<double>(one.wrong_where) >= least_parted * static_cast<double>(one.wrong) &&
           static_cast<double>(one.right - one.right_where) >= least_parted * static_cast<double>(one.right);
}

/// Best of two that part: the fewest exceptions, where that makes a difference, and the least far-fetched.
bool better(const Condition& a, int a_cost, const Condition& b, int b_cost)
{
    const auto exceptions = [](const Condition& one) { return one.wrong - one.wrong_where + one.right_where; };
    const bool a_clean = exceptions(a) == 0;
    const bool b_clean = exceptions(b) == 0;
    if (a_clean != b_clean) return a_clean;
    return a_cost != b_cost ? a_cost < b_cost : exceptions(a) < exceptions(b);
}

struct Found {
    std::optional<Condition> condition;
    int cost = 0;

    void offer(Condition other, int other_cost)
    {
        if (parted(other) && (!condition || better(other, other_cost, *condition, cost))) {
            condition = std::move(other);
            cost = other_cost;
        }
    }
};

/// Two joined: each must hold nearly wherever the answers are wrong.
void offer_joined(const std::vector<Candidate>& candidates, const std::vector<Fact>& facts,
                  const std::vector<bool>& wrong, Found& found)
{
    constexpr std::size_t most_joined = 40;
    constexpr int joining = 6;
    std::vector<std::pair<Condition, const Candidate*>> wide;
    for (const Candidate& candidate : candidates) {
        Condition one = measured(candidate, facts, wrong);
        const bool covers = static_cast<double>(one.wrong_where) >= least_parted * static_cast<double>(one.wrong);
        if (covers && one.right_where < one.right) wide.emplace_back(std::move(one), &candidate);
    }
    std::ranges::stable_sort(wide, {},
                             [](const auto& one) { return std::pair(one.first.right_where, one.second->cost); });
    if (wide.size() > most_joined) wide.resize(most_joined);
    for (std::size_t i = 0; i < wide.size(); ++i) {
        for (std::size_t j = i + 1; j < wide.size(); ++j) {
            const Candidate& a = *wide[i].second;
            const Candidate& b = *wide[j].second;
            if (a.cost + b.cost > joining) continue;
            const Candidate both{a.words + " and " + b.words,
                                 [one = a.holds, other = b.holds](const std::vector<Fact>& all, std::size_t question) {
                                     return one(all, question) && other(all, question);
                                 },
                                 joining + a.cost + b.cost, a.fitted || b.fitted, a.of_answer || b.of_answer};
            Condition joined = measured(both, facts, wrong);
            // Each must be needed, and together they must hold without exception: two say more by chance than one.
            const std::size_t needed = std::max(least_questions, joined.right / 10);
            const bool each_needed = wide[i].first.right_where >= joined.right_where + needed &&
                                     wide[j].first.right_where >= joined.right_where + needed;
            if (each_needed && joined.right_where == 0 && joined.wrong_where == joined.wrong)
                found.offer(std::move(joined), both.cost);
        }
    }
}

}

bool parts(const Condition& condition, const std::vector<Fact>& facts, const std::vector<bool>& wrong)
{
    const Condition again = measured({condition.words, condition.holds, 0}, facts, wrong);
    return again.wrong > 0 && again.right > 0 && parted(again);
}

std::optional<Condition> simplest_condition(const std::vector<Fact>& facts, const std::vector<bool>& wrong)
{
    const auto count = static_cast<std::size_t>(std::ranges::count(wrong, true));
    // Of very few among very many, anything is true.
    const std::size_t least = std::max(least_questions, wrong.size() / 20);
    if (count < least || wrong.size() - count < least) return std::nullopt;
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < facts.size(); ++i) {
        const std::size_t before = candidates.size();
        add_plain(facts, i, candidates);
        add_threshold(facts, i, wrong, candidates);
        for (std::size_t k = before; k < candidates.size(); ++k) candidates[k].of_answer = facts[i].answer;
        for (std::size_t j = i + 1; j < facts.size(); ++j) add_comparison(facts, i, j, candidates);
    }
    Found found;
    for (const Candidate& candidate : candidates) found.offer(measured(candidate, facts, wrong), candidate.cost);
    if (!found.condition) offer_joined(candidates, facts, wrong, found);
    return found.condition;
}

std::string sentence_of(const Condition& condition)
{
    return fmt::format("wrong wherever {} ({} of {}), right everywhere else ({} of {})", condition.words,
                       condition.wrong_where, condition.wrong, condition.right - condition.right_where,
                       condition.right);
}

}
