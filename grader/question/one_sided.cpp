#include "question/one_sided.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "question/possible_conditions.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t least_wrong_there = 8;
constexpr std::size_t least_right_elsewhere = 12;
constexpr double most_right_where = 0.6;   ///< of the right answers
constexpr double most_of_component = 0.4;  ///< … where it tells of one of a vector's: these are 0 for many a reason
constexpr double most_of_fitted = 0.35;    ///< … where it holds a bound that was put there
constexpr std::size_t least_wrong_of_fitted = 16;
constexpr double most_chance = 1e-5;  ///< that all wrong answers lie there: there are hundreds of conditions
constexpr double about_as_few = 1.2;

/// The share of right answers for which it holds; nothing where it does not hold of all wrong ones, or may be chance.
std::optional<double> share_of_right(const Condition& one, const std::vector<Fact>& facts)
{
    if (one.wrong_where < one.wrong || one.right - one.right_where < least_right_elsewhere) return std::nullopt;
    const double share = static_cast<double>(one.right_where) / static_cast<double>(one.right);
    const double chance = std::pow(std::max(share, 0.05), static_cast<double>(one.wrong));
    const bool is_component = one.fact && facts[*one.fact].component;
    if (one.fitted && (is_component || one.wrong < least_wrong_of_fitted)) return std::nullopt;
    const double most = one.fitted ? most_of_fitted : is_component ? most_of_component : most_right_where;
    return share <= most && chance <= most_chance ? std::optional(share) : std::nullopt;
}

}

std::optional<Condition> one_sided_condition(const std::vector<Fact>& facts, const std::vector<bool>& wrong)
{
    const auto count = static_cast<std::size_t>(std::ranges::count(wrong, true));
    if (count < least_wrong_there || wrong.size() - count < least_right_elsewhere) return std::nullopt;
    std::optional<Condition> best;
    double fewest = most_right_where;
    int cost = 0;
    for (const PossibleCondition& candidate : possible_conditions(facts, wrong)) {
        if (candidate.accidental || candidate.of_answer) continue;
        Condition one = measured(candidate, facts, wrong);
        const auto share = share_of_right(one, facts);
        if (!share) continue;
        // It parts them: whether that is the reason, others decide (simplest_condition).
        if (*share == 0) return std::nullopt;
        const bool is_better =
            !best || *share * about_as_few < fewest || (*share <= fewest * about_as_few && candidate.cost < cost);
        if (!is_better) continue;
        best = std::move(one);
        fewest = *share;
        cost = candidate.cost;
    }
    if (best) {
        best->one_sided = true;
        best->is_simple = false;
    }
    return best;
}

}
