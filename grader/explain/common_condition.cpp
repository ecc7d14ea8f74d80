#include "explain/common_condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "explain/samples.hpp"
#include "question/conditions.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t least_of_fixed = 6;  ///< questions on either side, where no fresh ones confirm it, or of a bound
/// Something that is so for 1 answer of 100 but one is found out with these many; few are asked at a time.
constexpr std::size_t enough_answers = 200;
constexpr std::size_t most_in_vector = 4;
constexpr std::size_t least_confirmed = 2;  ///< sets of fresh inputs with wrong answers
constexpr double most_common_seconds = 3;   ///< of one check, for fresh inputs

bool has_both(const std::vector<bool>& wrong, std::size_t least)
{
    return wrong_in(wrong) >= least && wrong.size() - wrong_in(wrong) >= least;
}

/// "the right answer is nothing" is what people say.
void replace(std::string& text, const std::string& from, const std::string& to)
{
    if (const std::size_t place = text.find(from); place != std::string::npos) text.replace(place, from.size(), to);
}

std::string in_plain_words(const Condition& condition)
{
    std::string text = sentence_of(condition);
    const std::string answer = has_answer;
    for (const char* const end : {" is not 0", " is positive", " is 1"})
        replace(text, answer + end, "something is to be found");
    for (const char* const end : {" is 0 or negative", " is not 1", " is 0"})
        replace(text, answer + end, "nothing is to be found");
    return text;
}

/// What fresh inputs say of a condition.
enum class Confirmed { no, untried, yes };

/// Does the condition part those of fresh inputs too, so many that a chance would have shown?
Confirmed confirmed_by(const Condition& condition, Samples& samples, ToldSample AskedSample::*of)
{
    const ToldSample& seen = samples.seen().*of;
    std::size_t wrong = condition.wrong;
    std::size_t right = condition.right;
    std::size_t confirmed = 0;
    for (std::size_t i = 1; i <= samples.fresh_sets(); ++i) {
        const ToldSample& fresh = samples.fresh(i).*of;
        if (fresh.names != seen.names) return Confirmed::no;
        // Rare ones may not come again at all.
        if (!has_both(fresh.wrong, 1)) continue;
        if (!parts(condition, fresh.facts, fresh.wrong)) return Confirmed::no;
        wrong += wrong_in(fresh.wrong);
        right += fresh.wrong.size() - wrong_in(fresh.wrong);
        if (++confirmed >= least_confirmed && std::min(wrong, right) >= enough_answers) break;
    }
    return confirmed >= least_confirmed ? Confirmed::yes : Confirmed::untried;
}

/// The simplest condition that parts wrong ones from right ones, if it does so on fresh inputs too, or if there can be
/// no others.
std::optional<CommonCondition> condition_of(Samples& samples, ToldSample AskedSample::*of)
{
    const ToldSample& seen = samples.seen().*of;
    if (seen.numbers.empty()) return std::nullopt;
    std::optional<Condition> condition = simplest_condition(seen.facts, seen.wrong);
    if (!condition) return std::nullopt;
    const bool fixed = samples.is_fixed();
    // Where a case asks the same at every desk, nothing can say that the bound is more than a number between them, nor
    // that one of the many entries of a right matrix has more to do with it than another.
    const bool by_chance =
        condition->fitted || (condition->of_answer && samples.seen().answers.components > most_in_vector);
    // Between few questions a bound can be put almost anywhere.
    if (condition->fitted && !has_both(seen.wrong, least_of_fixed)) return std::nullopt;
    const bool exact = has_both(seen.wrong, least_of_fixed) && condition->right_where == 0 &&
                       condition->wrong_where == condition->wrong;
    if (fixed && (by_chance || !exact)) return std::nullopt;
    const Confirmed confirmed = confirmed_by(*condition, samples, of);
    const bool holds = confirmed == Confirmed::yes || (fixed && confirmed == Confirmed::untried);
    if (!holds) return std::nullopt;
    return CommonCondition{*std::move(condition), of};
}

/// Of questions that have several answers, or else of answers.
std::optional<CommonCondition> common_condition(Samples& samples)
{
    std::optional<CommonCondition> found = condition_of(samples, &AskedSample::by_question);
    return found ? found : condition_of(samples, &AskedSample::by_answer);
}

/// What all wrong answers share, if it is so with fresh inputs too, so many that a chance would have shown.
std::string common_answer(Samples& samples)
{
    std::vector<std::string> patterns = answer_patterns(samples.seen().answers);
    std::size_t wrong = wrong_in(samples.seen().answers);
    const bool fixed = !patterns.empty() && samples.is_fixed();
    std::optional<AskedSample> pending;
    std::size_t confirmed = 0;
    for (std::size_t i = 1; i <= samples.fresh_sets() && !patterns.empty(); ++i) {
        AskedSample fresh = samples.fresh(i);
        // Of few nothing can be told: they are looked at together.
        if (pending && add(*pending, fresh)) fresh = *std::exchange(pending, std::nullopt);
        if (wrong_in(fresh.answers) < least_wrong) {
            pending = std::move(fresh);
            continue;
        }
        const std::vector<std::string> again = answer_patterns(fresh.answers);
        std::erase_if(patterns, [&](const std::string& one) { return std::ranges::find(again, one) == again.end(); });
        wrong += wrong_in(fresh.answers);
        if (++confirmed >= least_confirmed && (fixed || wrong >= enough_answers)) break;
    }
    if (confirmed == 0) patterns.clear();
    return patterns.empty() ? "" : patterns.front();
}

}

InCommon find_in_common(Worker& worker, const AskedCheck& asked, SpareTime& time)
{
    if (!time.is_left()) return {};
    const double before = worker.run_seconds();
    Samples samples(worker, asked, std::min(time.left(), most_common_seconds));
    InCommon found{common_condition(samples), common_answer(samples)};
    time.spend(worker.run_seconds() - before);
    return found;
}

std::string sentence_of(const InCommon& common)
{
    std::string text = common.condition ? in_plain_words(common.condition->condition) : "";
    if (!common.answer.empty()) text += fmt::format("{}every wrong answer {}", text.empty() ? "" : "; ", common.answer);
    return text;
}

std::optional<bool> holds_at(Worker& worker, const AskedCheck& asked, const CommonCondition& condition,
                             std::uint64_t seed)
{
    const AskedSample fresh = asked_sample(worker, asked, seed);
    const ToldSample& told = fresh.*condition.of;
    if (told.numbers.empty() || !has_both(told.wrong, 1)) return std::nullopt;
    return parts(condition.condition, told.facts, told.wrong);
}

std::optional<bool> holds_at(Worker& worker, const AskedCheck& asked, const std::string& pattern, std::uint64_t seed)
{
    const AskedSample fresh = asked_sample(worker, asked, seed);
    const std::vector<std::string> found = answer_patterns(fresh.answers);
    if (found.empty() && wrong_in(fresh.answers) < least_wrong) return std::nullopt;
    return std::ranges::find(found, pattern) != found.end();
}

}
