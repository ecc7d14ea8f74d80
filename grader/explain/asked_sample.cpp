#include "explain/asked_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "explain/row_labels.hpp"
#include "judge/rows/columns.hpp"
#include "question/history.hpp"
#include "question/names.hpp"

namespace umbral::grader {
namespace {

/// Answers whose questions are of one kind.
struct AnswersOfKind {
    const AskedAnswers& asked;
    const QuestionKind& kind;
    History history;
    std::vector<const AskedAnswer*> some;

    /// What is told of one of the questions, as questions_of() calls it.
    [[nodiscard]] std::vector<double> numbers_of(std::uint32_t question) const
    {
        std::vector<double> numbers = kind.questions.at(question);
        std::ranges::copy(history.numbers(question), std::back_inserter(numbers));
        return numbers;
    }
};

/// What is known of the right answer too.
void add_answer(const AskedAnswers& answers, const AskedAnswer& one, std::vector<double>& numbers)
{
    if (answers.optional) numbers.push_back(one.answer.expected.empty() ? 0 : 1);
    if (!one.row) {
        numbers.push_back(
            static_cast<double>(one.answer.expected.size() / std::max<std::size_t>(answers.components, 1)));
        return;
    }
    for (std::size_t i = 0; i < answers.components; ++i)
        numbers.push_back(one.answer.expected.empty() ? 0 : one.answer.expected[i]);
}

/// What 0, 1, … mean in this column of codes, as long as its name says so.
std::vector<std::string> meanings_of(const std::string& column)
{
    std::vector<std::string> words;
    for (std::string word = column_word(column, 0).word; !word.empty();
         word = column_word(column, static_cast<double>(words.size())).word)
        words.push_back(std::move(word));
    return words;
}

/// Adds what is known of right answers by name, as add_answer() adds the numbers.
void name_answers(const AskedAnswers& answers, QuestionTable& table)
{
    if (answers.optional) table.names.emplace_back(has_answer);
    if (answers.all.empty()) return;
    if (!answers.all.front().row) {
        table.names.emplace_back(length_of_answer);
        return;
    }
    for (std::size_t i = 0; i < answers.components; ++i) {
        const std::string column = i < answers.columns.size() ? answers.columns[i] : "";
        table.words.resize(table.names.size());
        table.words.push_back(meanings_of(column));
        if (is_label(answers, i)) {
            table.labels.push_back(table.names.size());
            table.names.push_back(column_word(column, 0).name);
            continue;
        }
        table.names.push_back(answers.components == 1 ? right_answer
                              : column.empty()        ? fmt::format("{}[{}]", right_answer, i)
                                               : fmt::format("{}.{}", right_answer, column_word(column, 0).name));
    }
}

/// A table that tells of right answers, and where among those to the same question each stands.
QuestionTable no_questions(const AskedAnswers& answers)
{
    QuestionTable table;
    table.names.emplace_back(place_in_call);
    table.words = {{"between others", "the first", "the last", "the only one"}};
    table.answers = 1;
    if (answers.optional) table.first = 1;
    return table;
}

/// Where an answer stands among those to the same question, as no_questions() calls it.
class PlacesInCalls {
public:
    explicit PlacesInCalls(const AnswersOfKind& answers)
    {
        for (const AskedAnswer* const one : answers.some) {
            if (!one->row) continue;
            auto& [first, last] = rows_.try_emplace(one->question, *one->row, *one->row).first->second;
            first = std::min(first, *one->row);
            last = std::max(last, *one->row);
        }
    }

    [[nodiscard]] double of(const AskedAnswer& one) const
    {
        if (!one.row) return 0;
        const auto& [first, last] = rows_.at(one.question);
        return (*one.row == first ? 1 : 0) + (*one.row == last ? 2 : 0);
    }

private:
    std::map<std::uint32_t, std::pair<std::size_t, std::size_t>> rows_;  ///< the first and the last of each question
};

/// The questions' own numbers, called as the interface calls them, and those of what was done before to their objects.
QuestionTable questions_of(const AskedCheck& asked, const AnswersOfKind& answers)
{
    QuestionTable table;
    const std::vector<std::string> parameters = parameter_names(asked.headers, answers.kind.function);
    for (const std::string& place : answers.kind.features) table.names.push_back(in_words(place, parameters));
    table.words = answers.kind.words;
    table.words.resize(table.names.size());
    std::ranges::copy(answers.history.names(asked.headers), std::back_inserter(table.names));
    std::ranges::copy(answers.history.words(), std::back_inserter(table.words));
    // That nothing is found where something is says more than what else is true of such questions.
    table.answers = table.names.size();
    if (answers.asked.optional) table.first = table.names.size();
    return table;
}

ToldSample told_of(QuestionTable table, std::vector<bool> wrong)
{
    std::vector<Fact> facts = facts_of(table);
    return {std::move(table.names), std::move(table.numbers), std::move(facts), std::move(wrong)};
}

/// `numbers_of` gives the numbers of an answer that `table` has names for.
ToldSample by_answer(QuestionTable table, const AnswersOfKind& answers,
                     const std::function<std::vector<double>(const AskedAnswer&)>& numbers_of)
{
    name_answers(answers.asked, table);
    std::vector<bool> wrong;
    for (const AskedAnswer* const one : answers.some) {
        std::vector<double> numbers = numbers_of(*one);
        add_answer(answers.asked, *one, numbers);
        table.numbers.push_back(std::move(numbers));
        wrong.push_back(one->answer.wrong);
    }
    return told_of(std::move(table), std::move(wrong));
}

ToldSample by_question(QuestionTable table, const AnswersOfKind& answers)
{
    struct Question {
        bool wrong = false;
        bool has_answer = false;
    };
    std::map<std::uint32_t, Question> questions;
    for (const AskedAnswer* const one : answers.some) {
        Question& question = questions[one->question];
        question.wrong = question.wrong || one->answer.wrong;
        question.has_answer = question.has_answer || !one->answer.expected.empty();
    }
    if (questions.size() == answers.some.size()) return {};
    if (answers.asked.optional) table.names.emplace_back(has_answer);
    std::vector<bool> wrong;
    for (const auto& [number, question] : questions) {
        table.numbers.push_back(answers.numbers_of(number));
        if (answers.asked.optional) table.numbers.back().push_back(question.has_answer ? 1 : 0);
        wrong.push_back(question.wrong);
    }
    return told_of(std::move(table), std::move(wrong));
}

/// AskedSample::lists; `like` says what a row is.
AnswerTable lists_of(const AnswersOfKind& answers, const AnswerTable& like)
{
    AnswerTable lists = like;
    lists.answers.clear();
    std::map<std::uint32_t, AnswerPair> all;
    for (const AskedAnswer* const one : answers.some) {
        if (!one->row || one->answer.refused) return lists;
        AnswerPair& list = all[one->question];
        std::ranges::copy(one->answer.yours, std::back_inserter(list.yours));
        std::ranges::copy(one->answer.expected, std::back_inserter(list.expected));
        list.wrong = list.wrong || one->answer.wrong;
    }
    const bool is_counted = like.components == 1 && std::ranges::all_of(all, [](const auto& one) {
                                const AnswerPair& list = one.second;
                                return !list.yours.empty() && !list.expected.empty() &&
                                       list.expected.front() + 1 == static_cast<double>(list.expected.size());
                            });
    for (auto& [question, list] : all) {
        if (is_counted) {
            list.yours.erase(list.yours.begin());
            list.expected.erase(list.expected.begin());
        }
        lists.answers.push_back(std::move(list));
    }
    return lists;
}

bool are_alike(const std::vector<Fact>& some, const std::vector<Fact>& others)
{
    return std::ranges::equal(some, others, {}, &Fact::words, &Fact::words);
}

void add_facts(std::vector<Fact>& facts, const std::vector<Fact>& others)
{
    for (std::size_t i = 0; i < facts.size(); ++i)
        std::ranges::copy(others[i].values, std::back_inserter(facts[i].values));
}

void add_told(ToldSample& told, const ToldSample& other)
{
    std::ranges::copy(other.numbers, std::back_inserter(told.numbers));
    std::ranges::copy(other.wrong, std::back_inserter(told.wrong));
    add_facts(told.facts, other.facts);
}

}

AskedSample asked_sample(Worker& worker, const AskedCheck& asked, std::uint64_t seed, const AskedSample* but)
{
    const AskedAnswers answers = asked_answers(worker, asked, seed);
    const QuestionLog& log = questions_at(worker, asked, seed);
    std::map<const QuestionKind*, std::vector<const AskedAnswer*>> by_kind;
    for (const AskedAnswer& one : answers.all) by_kind[log.kind_of(one.question)].push_back(&one);
    AskedSample result;
    // Of those that are asked the same, the one that is answered wrong is to be looked at.
    const auto most = std::ranges::max_element(by_kind, {}, [](const auto& one) {
        const auto wrong = std::ranges::count_if(one.second, [](const auto* answer) { return answer->answer.wrong; });
        return std::pair(wrong, one.second.size());
    });
    if (most == by_kind.end()) return result;
    auto& [kind, some] = *most;
    for (const auto& [other, of_other] : by_kind)
        for (const AskedAnswer* const one : of_other)
            if (other != kind && one->answer.wrong) result.others_wrong.push_back(one->answer);
    if (kind != nullptr && but != nullptr)
        std::erase_if(some, [&kind = kind, but](const AskedAnswer* one) {
            return but->questions.contains(kind->questions.at(one->question));
        });
    result.answers = {answers.components, answers.keys, answers.columns, {}, {}, answers.picture, false, answers.kinds};
    for (const AskedAnswer* const one : some) result.answers.answers.push_back(one->answer);
    if (kind == nullptr || some.empty()) return result;
    result.function = kind->function;
    for (const AskedAnswer* const one : some) result.questions.insert(kind->questions.at(one->question));
    const AnswersOfKind of_kind{answers, *kind, History(log, kind->function), some};
    const QuestionTable table = questions_of(asked, of_kind);
    result.by_answer =
        by_answer(table, of_kind, [&of_kind](const AskedAnswer& one) { return of_kind.numbers_of(one.question); });
    result.answers.facts = result.by_answer.facts;
    result.by_question = by_question(table, of_kind);
    result.answers.several = !result.by_question.numbers.empty();
    if (result.answers.several) {
        result.lists = lists_of(of_kind, result.answers);
        result.by_answer = by_answer(
            no_questions(answers), of_kind,
            [places = PlacesInCalls(of_kind)](const AskedAnswer& one) { return std::vector<double>{places.of(one)}; });
    }
    return result;
}

bool add(AskedSample& sample, const AskedSample& other)
{
    const bool alike =
        sample.answers.components == other.answers.components && sample.by_answer.names == other.by_answer.names &&
        sample.by_question.names == other.by_question.names && are_alike(sample.answers.facts, other.answers.facts) &&
        are_alike(sample.by_answer.facts, other.by_answer.facts) &&
        are_alike(sample.by_question.facts, other.by_question.facts);
    if (!alike) return false;
    std::ranges::copy(other.answers.answers, std::back_inserter(sample.answers.answers));
    std::ranges::copy(other.lists.answers, std::back_inserter(sample.lists.answers));
    std::ranges::copy(other.others_wrong, std::back_inserter(sample.others_wrong));
    sample.questions.insert(other.questions.begin(), other.questions.end());
    add_facts(sample.answers.facts, other.answers.facts);
    add_told(sample.by_answer, other.by_answer);
    add_told(sample.by_question, other.by_question);
    return true;
}

}
