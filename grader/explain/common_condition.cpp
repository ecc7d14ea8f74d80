#include "explain/common_condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <umbral/record/variation.hpp>
#include <utility>

#include "explain/asked_sample.hpp"
#include "model/digest.hpp"
#include "question/conditions.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t least_of_fixed = 6;  ///< questions on either side, where no fresh ones can confirm a condition
/// Something that is so for 1 answer of 100 but one is found out with these many; few are asked at a time.
constexpr std::size_t enough_answers = 200;
constexpr std::size_t enough_seen = 8;  ///< wrong answers in which something is looked for
constexpr std::size_t most_in_vector = 4;
constexpr std::size_t most_added = 3;       ///< sets of fresh inputs, where few answers are wrong
constexpr std::size_t least_confirmed = 2;  ///< sets of fresh inputs with wrong answers
constexpr std::size_t most_confirmed = 6;

std::size_t wrong_in(const std::vector<bool>& wrong)
{
    return static_cast<std::size_t>(std::ranges::count(wrong, true));
}

std::size_t wrong_in(const AnswerTable& table)
{
    return static_cast<std::size_t>(std::ranges::count_if(table.answers, &AnswerPair::wrong));
}

bool has_both(const std::vector<bool>& wrong, std::size_t least)
{
    return wrong_in(wrong) >= least && wrong.size() - wrong_in(wrong) >= least;
}

/// The answers that were graded, and those to fresh inputs, where what was seen is confirmed; each found out once, when
/// first asked for. Of a hidden case all inputs are fresh, and the same for everybody: what is said of them tells
/// nothing about those that were graded.
class Samples {
public:
    Samples(Worker& worker, const AskedCheck& asked) : worker_(worker), asked_(asked) {}

    /// In what few answers are wrong, more are looked at.
    const AskedSample& seen()
    {
        if (seen_) return *seen_;
        seen_ = asked_at(next_++);
        while (next_ <= most_added && wrong_in(seen_->answers) < enough_seen) {
            const AskedSample more = asked_at(next_);
            is_fixed_ = is_fixed_ || more.by_answer.numbers == seen_->by_answer.numbers;
            if (is_fixed_ || !add(*seen_, more)) break;
            ++next_;
        }
        return *seen_;
    }

    /// Are the same questions asked whatever the seed?
    bool is_fixed()
    {
        is_fixed_ = is_fixed_ || fresh(1).by_answer.numbers == seen().by_answer.numbers;
        return is_fixed_;
    }

    /// From 1 to most_confirmed; none of them was seen.
    const AskedSample& fresh(std::size_t number)
    {
        (void)seen();
        std::optional<AskedSample>& one = fresh_.at(number - 1);
        if (!one) one = asked_at(next_ - 1 + number);
        return *one;
    }

private:
    /// Fresh inputs vary what is written down in a driver, too: what is so of the one scene that it draws may be so by
    /// chance.
    [[nodiscard]] AskedSample asked_at(std::size_t place) const
    {
        if (place == 0 && !asked_.result.hidden) return asked_sample(worker_, asked_, asked_.result.seed);
        const std::uint64_t first = asked_.result.hidden
                                        ? case_seed("practice", "", "", asked_.exercise.id, asked_.check.case_name, 0)
                                        : asked_.result.seed;
        return asked_sample(worker_, asked_, VariedSeed::with_mark(first ^ (place * 0x9E3779B97F4A7C15U)));
    }

    Worker& worker_;
    const AskedCheck& asked_;
    std::optional<AskedSample> seen_;
    std::size_t next_ = 0;  ///< place of the first that was not seen
    bool is_fixed_ = false;
    std::array<std::optional<AskedSample>, most_confirmed> fresh_;
};

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

/// Does the condition part those of fresh inputs too, so many that a chance would have shown?
bool is_confirmed(const Condition& condition, Samples& samples, ToldSample AskedSample::*of)
{
    const ToldSample& seen = samples.seen().*of;
    std::size_t wrong = condition.wrong;
    std::size_t right = condition.right;
    std::size_t confirmed = 0;
    for (std::size_t i = 1; i <= most_confirmed; ++i) {
        const ToldSample& fresh = samples.fresh(i).*of;
        if (fresh.names != seen.names) return false;
        // Rare ones may not come again at all.
        if (!has_both(fresh.wrong, 1)) continue;
        if (!parts(condition, fresh.facts, fresh.wrong)) return false;
        wrong += wrong_in(fresh.wrong);
        right += fresh.wrong.size() - wrong_in(fresh.wrong);
        if (++confirmed >= least_confirmed && std::min(wrong, right) >= enough_answers) break;
    }
    return confirmed >= least_confirmed;
}

/// The simplest condition that parts wrong ones from right ones, if it does so on fresh inputs too, or if there can be
/// no others.
std::optional<CommonCondition> condition_of(Samples& samples, ToldSample AskedSample::*of)
{
    const ToldSample& seen = samples.seen().*of;
    if (seen.numbers.empty()) return std::nullopt;
    std::optional<Condition> condition = simplest_condition(seen.facts, seen.wrong);
    if (!condition) return std::nullopt;
    const bool same = samples.is_fixed();
    // Where a case always asks the same, nothing can say that the bound is more than a number between them, nor that
    // one of the many entries of a right matrix has more to do with it than another.
    const bool by_chance =
        condition->fitted || (condition->of_answer && samples.seen().answers.components > most_in_vector);
    if (same && by_chance) return std::nullopt;
    const bool holds = same ? has_both(seen.wrong, least_of_fixed) && condition->right_where == 0 &&
                                  condition->wrong_where == condition->wrong
                            : is_confirmed(*condition, samples, of);
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
    const bool same = !patterns.empty() && samples.is_fixed();
    std::optional<AskedSample> pending;
    std::size_t confirmed = 0;
    for (std::size_t i = 1; i <= most_confirmed && !patterns.empty(); ++i) {
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
        if (++confirmed >= least_confirmed && (same || wrong >= enough_answers)) break;
    }
    if (confirmed == 0) patterns.clear();
    return patterns.empty() ? "" : patterns.front();
}

}

InCommon find_in_common(Worker& worker, const AskedCheck& asked)
{
    Samples samples(worker, asked);
    return {common_condition(samples), common_answer(samples)};
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
    const auto wrong = std::ranges::count_if(fresh.answers.answers, &AnswerPair::wrong);
    if (found.empty() && wrong < static_cast<std::ptrdiff_t>(least_wrong)) return std::nullopt;
    return std::ranges::find(found, pattern) != found.end();
}

}
