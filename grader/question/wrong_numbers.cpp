#include "question/wrong_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "question/alike.hpp"
#include "question/answer_columns.hpp"
#include "question/distance_relation.hpp"
#include "question/number_changes.hpp"

namespace umbral::grader {
namespace {

/// Are there so many, and is each the same?
bool all_alike(const std::vector<double>& numbers)
{
    return numbers.size() >= least_wrong &&
           std::ranges::all_of(numbers, [&](double one) { return one == numbers.front(); });
}

NumberPairs numbers_in(const std::vector<const AnswerPair*>& wrong, std::size_t components, std::size_t component)
{
    NumberPairs numbers;
    for (const AnswerPair* one : wrong)
        for (std::size_t at = 0; at < one->yours.size(); at += components) {
            const auto row = [&](const std::vector<double>& side) { return std::span(side).subspan(at, components); };
            if (one->yours.size() > components && alike_rows(row(one->yours), row(one->expected))) continue;
            numbers.yours.push_back(one->yours[at + component]);
            numbers.right.push_back(one->expected[at + component]);
        }
    return numbers;
}

}

NumberPairs numbers_in(const std::vector<const AnswerPair*>& wrong, std::size_t components,
                       const std::vector<std::size_t>& which)
{
    NumberPairs all;
    for (const std::size_t component : which) {
        const NumberPairs some = numbers_in(wrong, components, component);
        all.yours.insert(all.yours.end(), some.yours.begin(), some.yours.end());
        all.right.insert(all.right.end(), some.right.begin(), some.right.end());
    }
    return all;
}

std::vector<std::size_t> questions_of(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong)
{
    std::vector<std::size_t> questions;
    for (const AnswerPair* one : wrong)
        if (one->yours.size() == table.components)
            questions.push_back(static_cast<std::size_t>(one - table.answers.data()));
    if (questions.size() != wrong.size()) questions.clear();
    return questions;
}

WrongVectors wrong_vectors(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong, std::size_t first,
                           std::size_t count)
{
    WrongVectors vectors{count, {}, {}, {}, questions_of(table, wrong)};
    if (vectors.questions.empty()) return vectors;
    for (const AnswerPair* one : wrong) {
        vectors.yours.push_back(std::span(one->yours).subspan(first, count));
        vectors.right.push_back(std::span(one->expected).subspan(first, count));
    }
    return vectors;
}

std::optional<AnswerPattern> change_of(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong,
                                       std::size_t component, const std::vector<std::string>& columns)
{
    NumberPairs pairs = numbers_in(wrong, table.components, component);
    if (auto change = change_of_numbers(pairs.yours, pairs.right)) return change;
    const WrongNumbers numbers{std::move(pairs.yours), std::move(pairs.right), questions_of(table, wrong)};
    if (!numbers.questions.empty()) {
        auto relation = relation_of(numbers, table.facts);
        if (!relation) relation = distance_relation({numbers}, {}, table.facts);
        if (!relation) relation = difference_relation(numbers, table.facts);
        if (relation) return AnswerPattern{*std::move(relation)};
    }
    if (table.components > 1 && all_alike(numbers.yours) && !table.picture)
        return AnswerPattern{fmt::format("{:.6g}", numbers.yours.front()), CommonTells::constant};
    for (std::size_t other = table.keys; other < std::min(table.components, columns.size()); ++other) {
        if (other == component) continue;
        const std::vector<double> right = numbers_in(wrong, table.components, other).right;
        if (const auto sign = sign_between(numbers.yours, right))
            return AnswerPattern{
                fmt::format("the right {}{}", columns[other], *sign > 0 ? "" : " with the opposite sign")};
    }
    return std::nullopt;
}

std::optional<std::string> distance_of(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong,
                                       const std::vector<std::size_t>& which, const std::vector<std::string>& columns)
{
    const std::vector<std::size_t> questions = questions_of(table, wrong);
    if (questions.empty() || columns.size() != table.components) return std::nullopt;
    std::vector<WrongNumbers> all;
    std::vector<std::string> names;
    for (const std::size_t component : which) {
        NumberPairs pairs = numbers_in(wrong, table.components, component);
        all.push_back({std::move(pairs.yours), std::move(pairs.right), questions});
        names.push_back(columns[component]);
    }
    return distance_relation(all, names, table.facts);
}

std::optional<std::string> of_another_name(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong,
                                           const std::vector<std::size_t>& which,
                                           const std::vector<std::string>& columns)
{
    const std::vector<NumbersTogether> groups = together(columns);
    const auto mine = std::ranges::find_if(groups, [&](const NumbersTogether& group) {
        return group.first <= which.front() && which.back() < group.first + group.size;
    });
    if (mine == groups.end()) return std::nullopt;
    const auto all_of = [&](const NumbersTogether& group) {
        std::vector<std::size_t> all;
        for (std::size_t i = 0; i < group.size; ++i) all.push_back(group.first + i);
        return numbers_in(wrong, table.components, all);
    };
    const NumberPairs numbers = all_of(*mine);
    for (const NumbersTogether& group : groups) {
        if (group.first == mine->first || group.size != mine->size) continue;
        if (const auto sign = sign_between(numbers.yours, all_of(group).right))
            return fmt::format("the right {}{}", group.name, *sign > 0 ? "" : " with the opposite sign");
    }
    return std::nullopt;
}

}
