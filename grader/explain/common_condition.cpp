#include "explain/common_condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "explain/common_answer.hpp"
#include "explain/other_cases.hpp"
#include "explain/samples.hpp"
#include "judge/rows/whole_number.hpp"
#include "question/conditions.hpp"
#include "question/one_sided.hpp"
#include "worker/spent_on_runs.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t least_of_fixed = 6;  ///< questions on either side, where no fresh ones confirm it, or of a bound
constexpr std::size_t least_different_wrong = 3;  ///< questions, for a condition on several numbers …
constexpr std::size_t least_joined_of_fixed = 8;  ///< … where no fresh ones confirm it
constexpr std::size_t most_in_vector = 4;
constexpr std::size_t least_fresh = 6;      ///< questions on either side, in these sets together
constexpr std::size_t least_elsewhere = 4;  ///< questions of another case that speak against a condition …
constexpr double most_against = 0.1;        ///< … and their share of those on that side
constexpr double most_beyond = 0.4;         ///< of a simple one: the share of wrong answers that it does not hold of
constexpr std::size_t many_others = 3;      ///< numbers that part questions as the one does that is told of
constexpr double most_common_seconds = 3;   ///< of one check, for fresh inputs

bool has_both(const std::vector<bool>& wrong, std::size_t least)
{
    return wrong_in(wrong) >= least && wrong.size() - wrong_in(wrong) >= least;
}

/// To how many different questions are these wrong answers? Rows of one are to the same; and where the whole numbers of
/// a question (how long its lists are, say) decide whether it is answered right, so are those with the same ones: a
/// case may have the same few shapes with every seed.
std::size_t different_wrong(const ToldSample& told)
{
    const auto is_asked = [&](std::size_t k) { return !told.facts[k].answer && !told.facts[k].label; };
    const auto different = [&](auto is_told) {
        std::set<std::vector<double>> wrong;
        std::set<std::vector<double>> right;
        for (std::size_t i = 0; i < told.wrong.size(); ++i) {
            std::vector<double> one;
            for (std::size_t k = 0; k < std::min(told.names.size(), told.facts.size()); ++k)
                if (is_told(k) && !std::isnan(told.facts[k].values[i])) one.push_back(told.facts[k].values[i]);
            (told.wrong[i] ? wrong : right).insert(std::move(one));
        }
        const bool decides =
            std::ranges::none_of(wrong, [&](const std::vector<double>& one) { return right.contains(one); });
        return std::pair(decides, wrong.size());
    };
    const auto [decides, shapes] = different(
        [&](std::size_t k) { return is_asked(k) && std::ranges::all_of(told.facts[k].values, is_whole_number); });
    return decides ? shapes : different(is_asked).second;
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

/// Does it tell of nothing but whether there is a right answer?
bool is_presence(const Condition& condition) { return condition.fact && condition.words.starts_with(has_answer); }

/// Of a condition that tells of nothing but whether there is a right answer: what happens there. Where something is to
/// be found, that answers are wrong says nothing; that none is given does.
std::string found_or_not(const CommonCondition& common, const AnswerPattern& answer)
{
    const Condition& condition = common.condition;
    const bool nothing = in_plain_words(condition).find("nothing is to be found") != std::string::npos;
    const std::string where =
        fmt::format("({} of {})", condition.wrong_where, condition.wrong_where + condition.right_where);
    if (nothing) return fmt::format("something is found wherever nothing is to be found {}", where);
    if (answer == none_given) return fmt::format("nothing is found wherever something is to be found {}", where);
    return "";
}

/// What fresh inputs say of a condition.
enum class Confirmed { no, untried, yes };

/// Does the condition part those of fresh inputs too, so many that a chance would have shown?
Confirmed confirmed_by(const Condition& condition, Samples& samples, ToldSample AskedSample::*of)
{
    const ToldSample& seen = samples.seen().*of;
    std::size_t wrong = 0;
    std::size_t right = 0;
    std::size_t confirmed = 0;
    for (std::size_t i = 1; i <= samples.fresh_sets(); ++i) {
        const ToldSample& fresh = samples.fresh(i).*of;
        if (fresh.names != seen.names) return Confirmed::no;
        // Rare ones may not come again at all.
        if (!has_both(fresh.wrong, 1)) continue;
        if (!parts(condition, fresh.facts, fresh.wrong)) return Confirmed::no;
        wrong += wrong_in(fresh.wrong);
        right += fresh.wrong.size() - wrong_in(fresh.wrong);
        const bool enough = std::min(wrong + condition.wrong, right + condition.right) >= enough_answers;
        if (++confirmed >= least_confirmed && enough) break;
    }
    return confirmed >= least_confirmed && std::min(wrong, right) >= least_fresh ? Confirmed::yes : Confirmed::untried;
}

/// What other cases say of a condition on questions to the same function: yes where wrong answers are on its side, and
/// right ones on the other.
Confirmed confirmed_elsewhere(const Condition& condition, OtherCases& others, const AskedSample& here,
                              ToldSample AskedSample::*of)
{
    const ToldSample& seen = here.*of;
    bool against = false;
    std::size_t wrong_where = 0;
    std::size_t right_elsewhere = 0;
    others.each(here.function, [&](const AskedSample& sample) {
        const ToldSample& told = sample.*of;
        if (told.names != seen.names || !std::ranges::equal(told.facts, seen.facts, {}, &Fact::words, &Fact::words))
            return true;
        std::size_t holds = 0;
        std::size_t wrong = 0;
        std::size_t wrong_and_holds = 0;
        for (std::size_t i = 0; i < told.wrong.size(); ++i) {
            if (condition.undecided && condition.undecided(told.facts, i)) continue;
            const bool here = condition.holds(told.facts, i);
            holds += here ? 1 : 0;
            wrong += told.wrong[i] ? 1 : 0;
            wrong_and_holds += here && told.wrong[i] ? 1 : 0;
        }
        // Of what is simple, one other bug or a few inputs to which it makes no difference say nothing yet.
        const auto speak_against = [&](std::size_t some, std::size_t all, double most) {
            against =
                against || (some >= least_elsewhere && static_cast<double>(some) > most * static_cast<double>(all));
        };
        const std::size_t holds_not = told.wrong.size() - holds;
        // A single number may be the reason, and make no difference there; what is put together, or fitted, may not.
        if (!condition.one_sided && (!condition.fact || condition.fitted || condition.is_simple))
            speak_against(holds - wrong_and_holds, holds, condition.is_simple ? 1 - most_against : most_against);
        if (condition.is_simple)
            speak_against(wrong - wrong_and_holds, wrong, most_beyond);
        else
            speak_against(wrong - wrong_and_holds, holds_not, most_against);
        wrong_where += wrong_and_holds;
        right_elsewhere += holds_not - (wrong - wrong_and_holds);
        return !against;
    });
    if (against) return Confirmed::no;
    return std::min(wrong_where, right_elsewhere) >= least_elsewhere ? Confirmed::yes : Confirmed::untried;
}

/// The simplest condition that parts wrong ones from right ones, if it does so on fresh inputs too, or if there can be
/// no others. It must be so in other cases as well, as far as these ask the same: what is simple, by and large.
std::optional<CommonCondition> condition_of(OtherCases& others, Samples& samples, ToldSample AskedSample::*of)
{
    const ToldSample& seen = samples.seen().*of;
    if (seen.numbers.empty()) return std::nullopt;
    std::optional<Condition> condition = simplest_condition(seen.facts, seen.wrong);
    if (!condition) return std::nullopt;
    // A first row is often a number of rows, and another thing than those behind it.
    if (condition->words == std::string(place_in_call) + " is not the first") return std::nullopt;
    // Each of so many numbers may be the reason, or none.
    if (condition->also_told_by.size() >= many_others) return std::nullopt;
    // That one of the many entries of a right matrix is 0 follows from much else.
    if (condition->of_answer && samples.seen().answers.components > most_in_vector) return std::nullopt;
    const bool fixed = samples.is_fixed();
    // Of two numbers together anything parts a few.
    const bool is_joined = !condition->fact && !condition->compares;
    if (is_joined && different_wrong(seen) < (fixed ? least_joined_of_fixed : least_different_wrong))
        return std::nullopt;
    // Between few questions a bound can be put almost anywhere.
    if (condition->fitted && !has_both(seen.wrong, least_of_fixed)) return std::nullopt;
    const bool exact = condition->right_where == 0 && condition->wrong_where == condition->wrong;
    // Where a case asks the same at every desk, nothing can say that the bound is more than a number between them.
    if (fixed && (condition->fitted || !exact)) return std::nullopt;
    const Confirmed confirmed = confirmed_by(*condition, samples, of);
    if (confirmed == Confirmed::no || (confirmed == Confirmed::untried && !fixed)) return std::nullopt;
    const bool are_few = fixed && !has_both(seen.wrong, least_of_fixed);
    // What is said of that alone is what the answers are, and these are looked for elsewhere.
    if (is_presence(*condition) && !are_few) return CommonCondition{*std::move(condition), of};
    const Confirmed elsewhere = confirmed_elsewhere(*condition, others, samples.seen(), of);
    // Of few questions, other cases must say the same.
    if (are_few && elsewhere != Confirmed::yes) return std::nullopt;
    // That two numbers are equal holds on by chance where neither changes, and hardly where both do.
    const bool may_be_untried = condition->is_simple || !fixed || (condition->compares && confirmed == Confirmed::yes);
    if (elsewhere == Confirmed::no || (elsewhere == Confirmed::untried && !may_be_untried)) return std::nullopt;
    return CommonCondition{*std::move(condition), of};
}

/// Where answers are wrong only, though not all of them. Fresh inputs must say the same, and other cases nothing else.
std::optional<CommonCondition> one_sided_condition_of(OtherCases& others, Samples& samples, ToldSample AskedSample::*of)
{
    const ToldSample& seen = samples.seen().*of;
    if (seen.numbers.empty() || samples.is_fixed()) return std::nullopt;
    std::optional<Condition> condition = one_sided_condition(seen.facts, seen.wrong);
    if (!condition || condition->words.starts_with(place_in_call)) return std::nullopt;
    if (confirmed_by(*condition, samples, of) != Confirmed::yes) return std::nullopt;
    if (confirmed_elsewhere(*condition, others, samples.seen(), of) == Confirmed::no) return std::nullopt;
    // Where nothing can be done wrong, all mistakes are right.
    const bool is_so_of_most = samples.is_so_of_most_mistakes([&](const AskedSample& mistake) -> std::optional<bool> {
        const ToldSample& told = mistake.*of;
        if (told.names != seen.names || !has_both(told.wrong, 1)) return std::nullopt;
        return parts(*condition, told.facts, told.wrong);
    });
    if (is_so_of_most) return std::nullopt;
    return CommonCondition{*std::move(condition), of};
}

/// Of questions that have several answers, or else of answers.
std::optional<CommonCondition> common_condition(OtherCases& others, Samples& samples)
{
    for (const auto find : {condition_of, one_sided_condition_of})
        for (const auto of : {&AskedSample::by_question, &AskedSample::by_answer})
            if (std::optional<CommonCondition> found = find(others, samples, of)) return found;
    return std::nullopt;
}

/// Does it say how many times the right ones wrong answers are, or that these have the opposite sign?
bool is_multiple(const AnswerPattern& answer)
{
    return answer.tells == CommonTells::multiple || answer.tells == CommonTells::opposite ||
           answer.words.ends_with("opposite sign") || answer.words.find(" times the right one") != std::string::npos;
}

}

InCommon find_in_common(Worker& worker, const AskedCheck& asked, SpareTime& time)
{
    if (!time.is_left()) return {};
    const SpentOnRuns spent(time, worker);
    Samples samples(worker, asked, std::min(time.left(), most_common_seconds));
    OtherCases others(worker, asked);
    return {common_condition(others, samples), common_answer(others, samples)};
}

AnswerPattern sentence_of(const InCommon& common)
{
    AnswerPattern answer = common.answer;
    if (!answer.words.empty())
        answer.words.insert(0, answer.tells == CommonTells::mostly ? "most wrong answers " : "every wrong answer ");
    if (!common.condition) return answer;
    const Condition& condition = common.condition->condition;
    if (is_presence(condition)) {
        std::string text = found_or_not(*common.condition, common.answer);
        return text.empty() ? answer : AnswerPattern{std::move(text)};
    }
    // Where the right number is 0, a factor makes no difference.
    if (is_multiple(answer) && condition.words.ends_with(" is not 0")) return answer;
    // That an answer which is always the same is wrong where another one is right says nothing.
    if (answer.tells == CommonTells::constant && condition.of_answer) return answer;
    AnswerPattern told{in_plain_words(condition)};
    const bool is_joined = !condition.fact && !condition.compares;
    if (condition.one_sided && (answer.words.empty() || is_vague(answer.tells))) told.tells = CommonTells::one_sided;
    told.of_question = is_joined || !condition.words.starts_with(right_answer);
    // What may be chance is said last.
    if (!answer.words.empty())
        told.words =
            condition.also_told_by.empty() ? told.words + "; " + answer.words : answer.words + "; " + told.words;
    return told;
}

std::optional<bool> holds_at(Worker& worker, const AskedCheck& asked, const CommonCondition& condition,
                             std::uint64_t seed)
{
    const AskedSample fresh = asked_sample(worker, asked, seed);
    const ToldSample& told = fresh.*condition.of;
    if (told.numbers.empty() || !has_both(told.wrong, 1)) return std::nullopt;
    return parts(condition.condition, told.facts, told.wrong);
}

}
