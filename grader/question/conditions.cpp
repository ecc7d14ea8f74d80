#include "question/conditions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "question/names.hpp"
#include "question/possible_conditions.hpp"
#include "text/joined.hpp"

namespace umbral::grader {
namespace {

/// One number or length of the question and no bound, or a sign: that a product or a coordinate is just 0 may follow
/// from how the questions were made.
bool is_simple(const PossibleCondition& one, const std::vector<Fact>& facts)
{
    if (!one.fact || one.fitted) return false;
    const Fact& fact = facts[*one.fact];
    if (fact.first) return true;
    if (fact.answer) return false;
    const bool is_one = fact.kind == Fact::Kind::number || fact.kind == Fact::Kind::length;
    return (is_one && !fact.component) || one.words.ends_with("negative") || one.words.ends_with("positive");
}

/// Where few are wrong, those few right ones for which it holds would be as many.
bool parted(const Condition& one)
{
    constexpr std::size_t most_of_wrong = 9;
    return static_cast<double>(one.wrong_where) >= least_parted * static_cast<double>(one.wrong) &&
           static_cast<double>(one.right - one.right_where) >= least_parted * static_cast<double>(one.right) &&
           one.right_where * most_of_wrong <= one.wrong_where;
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
void offer_joined(const std::vector<PossibleCondition>& candidates, const std::vector<Fact>& facts,
                  const std::vector<bool>& wrong, Found& found)
{
    constexpr std::size_t most_joined = 40;
    constexpr int joining = 6;
    std::vector<std::pair<Condition, const PossibleCondition*>> wide;
    for (const PossibleCondition& candidate : candidates) {
        if (candidate.accidental) continue;
        Condition one = measured(candidate, facts, wrong);
        const bool covers = static_cast<double>(one.wrong_where) >= least_parted * static_cast<double>(one.wrong);
        if (covers && one.right_where < one.right) wide.emplace_back(std::move(one), &candidate);
    }
    std::ranges::stable_sort(wide, {},
                             [](const auto& one) { return std::pair(one.first.right_where, one.second->cost); });
    if (wide.size() > most_joined) wide.resize(most_joined);
    for (std::size_t i = 0; i < wide.size(); ++i) {
        for (std::size_t j = i + 1; j < wide.size(); ++j) {
            const PossibleCondition& a = *wide[i].second;
            const PossibleCondition& b = *wide[j].second;
            if (a.cost + b.cost > joining) continue;
            const PossibleCondition both{
                a.words + " and " + b.words,
                [one = a.holds, other = b.holds](const std::vector<Fact>& all, std::size_t question) {
                    return one(all, question) && other(all, question);
                },
                joining + a.cost + b.cost, a.fitted || b.fitted, a.of_answer || b.of_answer};
            Condition joined = measured(both, facts, wrong);
            // Each must be needed, and together they must hold without exception: two say more by chance than one.
            const std::size_t needed = std::max(least_questions, std::min(joined.right / 10, joined.wrong / 2));
            const bool each_needed = wide[i].first.right_where >= joined.right_where + needed &&
                                     wide[j].first.right_where >= joined.right_where + needed;
            if (each_needed && joined.right_where == 0 && joined.wrong_where == joined.wrong)
                found.offer(std::move(joined), both.cost);
        }
    }
}

/// What is said of a fact: " is odd".
std::string_view said_of(const PossibleCondition& one, const std::vector<Fact>& facts)
{
    const std::string& words = facts[*one.fact].words;
    return one.words.starts_with(words) ? std::string_view(one.words).substr(words.size()) : std::string_view();
}

/// The same of two or three numbers that lie together, one of which is enough: "a.width is odd or a.height is odd".
/// Each must hold of no right answer, and be needed.
void offer_either(const std::vector<PossibleCondition>& candidates, const std::vector<Fact>& facts,
                  const std::vector<bool>& wrong, Found& found)
{
    constexpr std::size_t most = 3;
    constexpr int joining = 7;
    std::map<std::pair<std::string_view, std::string_view>, std::vector<const PossibleCondition*>> alike;
    for (const PossibleCondition& candidate : candidates) {
        if (candidate.accidental || candidate.fitted || !candidate.fact || candidate.of_answer) continue;
        if (facts[*candidate.fact].kind != Fact::Kind::number || said_of(candidate, facts).empty()) continue;
        const Condition one = measured(candidate, facts, wrong);
        if (one.right_where == 0 && one.wrong_where >= least_questions)
            alike[{owner_of(facts[*candidate.fact].words), said_of(candidate, facts)}].push_back(&candidate);
    }
    for (const auto& [what, several] : alike) {
        if (several.size() < 2 || several.size() > most) continue;
        std::vector<std::string> words;
        std::vector<std::function<bool(const std::vector<Fact>&, std::size_t)>> tests;
        for (const PossibleCondition* const one : several) {
            words.push_back(one->words);
            tests.push_back(one->holds);
        }
        const auto any_but = [tests](std::size_t left_out) {
            return [tests, left_out](const std::vector<Fact>& all, std::size_t question) {
                for (std::size_t i = 0; i < tests.size(); ++i)
                    if (i != left_out && tests[i](all, question)) return true;
                return false;
            };
        };
        const int cost = joining + several.front()->cost;
        const Condition joined =
            measured({fmt::format("{}", fmt::join(words, " or ")), any_but(tests.size()), cost}, facts, wrong);
        bool each_needed = joined.wrong_where == joined.wrong;
        for (std::size_t i = 0; each_needed && i < tests.size(); ++i)
            each_needed = measured({"", any_but(i), cost}, facts, wrong).wrong_where + 2 <= joined.wrong_where;
        if (each_needed) found.offer(joined, cost);
    }
}

/// Numbers of the questions, other than those that the condition names, of which one alone parts them as it does.
std::vector<std::string> others_that_part_alike(const Condition& condition,
                                                const std::vector<PossibleCondition>& candidates,
                                                const std::vector<Fact>& facts)
{
    std::vector<std::string> others;
    for (const PossibleCondition& candidate : candidates) {
        if (!candidate.fact) continue;
        const Fact& fact = facts[*candidate.fact];
        const bool counts = fact.kind == Fact::Kind::number && !fact.component && !fact.answer;
        const bool is_told = condition.words.find(fact.words) != std::string::npos ||
                             std::ranges::find(others, fact.words) != others.end();
        if (!counts || is_told) continue;
        bool alike = true;
        for (std::size_t i = 0; alike && i < fact.values.size(); ++i)
            alike = candidate.holds(facts, i) == condition.holds(facts, i);
        if (alike) others.push_back(fact.words);
    }
    return others;
}

/// "a, b and 2 others tell them apart as well"
std::string told_by(const std::vector<std::string>& others)
{
    constexpr std::size_t most = 3;
    if (others.size() == 1) return others.front() + " tells them apart as well";
    std::vector<std::string> named(others.begin(),
                                   others.begin() + static_cast<std::ptrdiff_t>(std::min(most, others.size())));
    const std::size_t left = others.size() - named.size();
    if (left > 0) named.push_back(left == 1 ? "another number" : fmt::format("{} others", left));
    return joined_with_and(named) + " tell them apart as well";
}

}

Condition measured(const PossibleCondition& candidate, const std::vector<Fact>& facts, const std::vector<bool>& wrong)
{
    Condition condition{.words = candidate.words,
                        .holds = candidate.holds,
                        .undecided = candidate.undecided,
                        .fitted = candidate.fitted,
                        .of_answer = candidate.of_answer,
                        .is_simple = is_simple(candidate, facts),
                        .fact = candidate.fact,
                        .compares = candidate.compares,
                        .also_told_by = {}};
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        if (candidate.undecided && candidate.undecided(facts, i)) continue;
        const bool holds = candidate.holds(facts, i);
        ++(wrong[i] ? condition.wrong : condition.right);
        if (holds) ++(wrong[i] ? condition.wrong_where : condition.right_where);
    }
    return condition;
}

bool parts(const Condition& condition, const std::vector<Fact>& facts, const std::vector<bool>& wrong)
{
    PossibleCondition candidate{condition.words, condition.holds};
    candidate.undecided = condition.undecided;
    const Condition again = measured(candidate, facts, wrong);
    if (again.wrong == 0 || again.right == 0) return false;
    return condition.one_sided ? again.wrong_where == again.wrong && again.right_where < again.right : parted(again);
}

std::optional<Condition> simplest_condition(const std::vector<Fact>& facts, const std::vector<bool>& wrong)
{
    const auto count = static_cast<std::size_t>(std::ranges::count(wrong, true));
    if (count < least_questions || wrong.size() - count < least_questions) return std::nullopt;
    const std::vector<PossibleCondition> all = possible_conditions(facts, wrong);
    Found found;
    for (const PossibleCondition& candidate : all)
        if (!candidate.accidental) found.offer(measured(candidate, facts, wrong), candidate.cost);
    if (!found.condition) offer_either(all, facts, wrong, found);
    if (!found.condition) offer_joined(all, facts, wrong, found);
    // What is to be found is reason enough.
    if (found.condition && !found.condition->of_answer)
        found.condition->also_told_by = others_that_part_alike(*found.condition, all, facts);
    return found.condition;
}

std::string sentence_of(const Condition& condition)
{
    if (condition.one_sided)
        return fmt::format("wrong only where {} ({} of {}), right everywhere else ({} of {})", condition.words,
                           condition.wrong_where, condition.wrong_where + condition.right_where,
                           condition.right - condition.right_where, condition.right - condition.right_where);
    std::string text =
        fmt::format("wrong wherever {} ({} of {}), right everywhere else ({} of {})", condition.words,
                    condition.wrong_where, condition.wrong, condition.right - condition.right_where, condition.right);
    if (!condition.also_told_by.empty()) text += "; " + told_by(condition.also_told_by);
    return text;
}

}
