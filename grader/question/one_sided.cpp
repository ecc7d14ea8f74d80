#include "question/one_sided.hpp"

#include <algorithm>
#include <cmath>

#include "question/possible_conditions.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t least_wrong_there = 8;
constexpr std::size_t least_right_elsewhere = 12;
constexpr double most_right_where = 0.6;   ///< of the right answers
constexpr double most_of_component = 0.4;  ///< … where it tells of one of a vector's: these are 0 for many a reason
constexpr double most_chance = 1e-5;       ///< that all wrong answers lie there: there are hundreds of conditions
constexpr double about_as_few = 1.2;

/// The share of right answers for which it holds; nothing where it does not hold of all wrong ones, or may be chance.
std::optional<double> right_where(const PossibleCondition& candidate, const std::vector<Fact>& facts,
                                  const std::vector<bool>& wrong)
{
    std::size_t right = 0;
    std::size_t where = 0;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        const bool holds = candidate.holds(facts, i);
        if (wrong[i] && !holds) return std::nullopt;
        right += wrong[i] ? 0 : 1;
        where += !wrong[i] && holds ? 1 : 0;
    }
    if (right - where < least_right_elsewhere) return std::nullopt;
    const double share = static_cast<double>(where) / static_cast<double>(right);
    const double chance = std::pow(std::max(share, 0.05), static_cast<double>(wrong.size() - right));
    const bool is_component = candidate.fact && facts[*candidate.fact].component;
    return share <= (is_component ? most_of_component : most_right_where) && chance <= most_chance
               ? std::optional(share)
               : std::nullopt;
}

}

std::optional<Condition> one_sided_condition(const std::vector<Fact>& facts, const std::vector<bool>& wrong)
{
    const auto count = static_cast<std::size_t>(std::ranges::count(wrong, true));
    if (count < least_wrong_there || wrong.size() - count < least_right_elsewhere) return std::nullopt;
    const std::vector<PossibleCondition> all = possible_conditions(facts, wrong);
    const PossibleCondition* best = nullptr;
    double fewest = most_right_where;
    for (const PossibleCondition& candidate : all) {
        if (candidate.accidental || candidate.fitted || candidate.of_answer) continue;
        const auto share = right_where(candidate, facts, wrong);
        if (!share) continue;
        // It parts them: whether that is the reason, others decide (simplest_condition).
        if (*share == 0) return std::nullopt;
        const bool is_better = best == nullptr || *share * about_as_few < fewest ||
                               (*share <= fewest * about_as_few && candidate.cost < best->cost);
        if (!is_better) continue;
        best = &candidate;
        fewest = *share;
    }
    if (best == nullptr) return std::nullopt;
    Condition condition{.words = best->words,
                        .holds = best->holds,
                        .one_sided = true,
                        .fact = best->fact,
                        .compares = best->compares,
                        .also_told_by = {}};
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        ++(wrong[i] ? condition.wrong : condition.right);
        if (best->holds(facts, i)) ++(wrong[i] ? condition.wrong_where : condition.right_where);
    }
    return condition;
}

}
