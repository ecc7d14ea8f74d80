#include "batch/common_condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "question/conditions.hpp"
#include "question/names.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t least_of_fixed = 6;  ///< questions on either side, where no fresh ones can confirm a condition
/// Something that is so for 1 answer of 100 but one is found out with these many; few are asked at a time.
constexpr std::size_t enough_answers = 200;
constexpr std::size_t most_in_vector = 4;
constexpr std::size_t least_confirmed = 2;  ///< sets of fresh inputs
constexpr std::size_t most_confirmed = 6;
constexpr const char* right_answer = "the right answer";
constexpr const char* has_answer = "there being a right answer";

/// Answers whose questions are of one kind, and what is known of each.
struct Sample {
    QuestionTable table;
    AnswerTable answers;  ///< in the same order, with what is told of the questions
};

std::vector<bool> which_wrong(const Sample& sample)
{
    std::vector<bool> wrong;
    for (const AnswerPair& one : sample.answers.answers) wrong.push_back(one.wrong);
    return wrong;
}

/// What is known of the right answer too.
void add_answer(const AskedAnswers& answers, const AskedAnswer& one, std::vector<double>& numbers)
{
    if (answers.optional) numbers.push_back(one.answer.expected.empty() ? 0 : 1);
    if (!one.row) return;
    for (std::size_t i = 0; i < answers.components; ++i)
        numbers.push_back(one.answer.expected.empty() ? 0 : one.answer.expected[i]);
}

std::vector<std::string> answer_names(const AskedAnswers& answers)
{
    std::vector<std::string> names;
    if (answers.optional) names.emplace_back(has_answer);
    if (answers.all.empty() || !answers.all.front().row) return names;
    for (std::size_t i = 0; i < answers.components; ++i)
        names.push_back(answers.components == 1      ? right_answer
                        : i < answers.columns.size() ? fmt::format("{}.{}", right_answer, answers.columns[i])
                                                     : fmt::format("{}[{}]", right_answer, i));
    return names;
}

/// The answers whose questions are of the kind that most have.
Sample sample(Worker& worker, const AskedCheck& asked, std::uint64_t seed)
{
    const AskedAnswers answers = asked_answers(worker, asked, seed);
    const QuestionLog& log =
        seed == asked.result.seed ? asked.log : worker.questions(asked.exercise, asked.check.case_name, seed);
    std::map<const QuestionKind*, std::vector<const AskedAnswer*>> by_kind;
    for (const AskedAnswer& one : answers.all) by_kind[log.kind_of(one.question)].push_back(&one);
    Sample result;
    const auto most = std::ranges::max_element(by_kind, {}, [](const auto& one) { return one.second.size(); });
    if (most == by_kind.end()) return result;
    const auto& [kind, some] = *most;
    result.answers = {answers.components, answers.keys, answers.columns, {}, {}};
    for (const AskedAnswer* const one : some) result.answers.answers.push_back(one->answer);
    if (kind == nullptr) return result;
    const std::vector<std::string> parameters = parameter_names(asked.headers, kind->function);
    for (const std::string& place : kind->features) result.table.names.push_back(in_words(place, parameters));
    // That nothing is found where something is says more than what else is true of such questions.
    result.table.answers = result.table.names.size();
    result.table.words = kind->words;
    if (answers.optional) result.table.first = result.table.names.size();
    std::ranges::copy(answer_names(answers), std::back_inserter(result.table.names));
    for (const AskedAnswer* const one : some) {
        std::vector<double> numbers = kind->questions.at(one->question);
        add_answer(answers, *one, numbers);
        result.table.numbers.push_back(std::move(numbers));
    }
    result.answers.facts = facts_of(result.table);
    return result;
}

bool has_both(const std::vector<bool>& wrong, std::size_t least)
{
    const auto count = static_cast<std::size_t>(std::ranges::count(wrong, true));
    return count >= least && wrong.size() - count >= least;
}

/// The answers that were graded, and those to fresh inputs, where what was seen is confirmed; each found out once, when
/// first asked for.
class Samples {
public:
    Samples(Worker& worker, const AskedCheck& asked) : worker_(worker), asked_(asked) {}

    const Sample& seen() { return at(0); }
    /// From 1 to most_confirmed.
    const Sample& fresh(std::size_t number) { return at(number); }

private:
    const Sample& at(std::size_t place)
    {
        std::optional<Sample>& one = samples_.at(place);
        if (!one) one = sample(worker_, asked_, asked_.result.seed ^ (place * 0x9E3779B97F4A7C15U));
        return *one;
    }

    Worker& worker_;
    const AskedCheck& asked_;
    std::array<std::optional<Sample>, 1 + most_confirmed> samples_;
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

/// Does the condition part the answers to fresh inputs too, so many that a chance would have shown?
bool is_confirmed(const Condition& condition, Samples& samples)
{
    std::size_t wrong = condition.wrong;
    std::size_t right = condition.right;
    for (std::size_t i = 1; i <= most_confirmed; ++i) {
        const Sample& fresh = samples.fresh(i);
        const std::vector<bool> which = which_wrong(fresh);
        // Rare ones may not come again at all.
        const bool none = fresh.table.names == samples.seen().table.names && !has_both(which, 1);
        if (none && i > least_confirmed) continue;
        if (none || fresh.table.names != samples.seen().table.names) return false;
        if (!parts(condition, fresh.answers.facts, which)) return false;
        wrong += static_cast<std::size_t>(std::ranges::count(which, true));
        right += static_cast<std::size_t>(std::ranges::count(which, false));
        if (i >= least_confirmed && std::min(wrong, right) >= enough_answers) break;
    }
    return true;
}

/// The simplest condition that parts wrong answers from right ones, if it does so on fresh inputs too, or if there can
/// be no others.
std::optional<Condition> common_condition(Samples& samples)
{
    const Sample& seen = samples.seen();
    if (seen.table.numbers.empty()) return std::nullopt;
    const std::vector<bool> wrong = which_wrong(seen);
    std::optional<Condition> condition = simplest_condition(seen.answers.facts, wrong);
    if (!condition) return std::nullopt;
    const Sample& fresh = samples.fresh(1);
    const bool same = fresh.table.names == seen.table.names && fresh.table.numbers == seen.table.numbers;
    // Where a case always asks the same, nothing can say that the bound is more than a number between them, nor that
    // one of the many entries of a right matrix has more to do with it than another.
    const bool by_chance = condition->fitted || (condition->of_answer && seen.answers.components > most_in_vector);
    if (same && by_chance) return std::nullopt;
    const bool holds = same ? has_both(wrong, least_of_fixed) && condition->right_where == 0 &&
                                  condition->wrong_where == condition->wrong
                            : is_confirmed(*condition, samples);
    return holds ? condition : std::nullopt;
}

/// What all wrong answers share, if it is so with fresh inputs too, so many that a chance would have shown.
std::string common_answer(Samples& samples)
{
    const auto count = [](const Sample& one) {
        return static_cast<std::size_t>(std::ranges::count(which_wrong(one), true));
    };
    std::vector<std::string> patterns = answer_patterns(samples.seen().answers);
    std::size_t wrong = count(samples.seen());
    const bool same = !patterns.empty() && samples.fresh(1).table.numbers == samples.seen().table.numbers;
    for (std::size_t i = 1; i <= most_confirmed && !patterns.empty(); ++i) {
        const Sample& fresh = samples.fresh(i);
        if (i > least_confirmed && count(fresh) < least_wrong) continue;
        const std::vector<std::string> again = answer_patterns(fresh.answers);
        std::erase_if(patterns, [&](const std::string& one) { return std::ranges::find(again, one) == again.end(); });
        wrong += count(fresh);
        if (i >= least_confirmed && (same || wrong >= enough_answers)) break;
    }
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
    std::string text = common.condition ? in_plain_words(*common.condition) : "";
    if (!common.answer.empty()) text += fmt::format("{}every wrong answer {}", text.empty() ? "" : "; ", common.answer);
    return text;
}

std::optional<bool> holds_at(Worker& worker, const AskedCheck& asked, const Condition& condition, std::uint64_t seed)
{
    const Sample fresh = sample(worker, asked, seed);
    const std::vector<bool> wrong = which_wrong(fresh);
    if (fresh.table.numbers.empty() || !has_both(wrong, 1)) return std::nullopt;
    return parts(condition, fresh.answers.facts, wrong);
}

std::optional<bool> holds_at(Worker& worker, const AskedCheck& asked, const std::string& pattern, std::uint64_t seed)
{
    const Sample fresh = sample(worker, asked, seed);
    const std::vector<std::string> found = answer_patterns(fresh.answers);
    const auto wrong = std::ranges::count_if(fresh.answers.answers, &AnswerPair::wrong);
    if (found.empty() && wrong < static_cast<std::ptrdiff_t>(least_wrong)) return std::nullopt;
    return std::ranges::find(found, pattern) != found.end();
}

}
