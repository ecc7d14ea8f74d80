#include "question/size_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "question/names.hpp"
#include "question/plain_conditions.hpp"
#include "question/told_fact.hpp"
#include "text/joined.hpp"

namespace umbral::grader {
namespace {

/// Of more than these, what one is beside the others is no more than a list of names.
constexpr std::size_t most_together = 5;

void add_size(std::string words, const QuestionTable& table, const auto& value, std::vector<Fact>& facts)
{
    facts.push_back(told_fact("the size of " + std::move(words), Fact::Kind::size, table,
                              [&](const auto& row) { return std::abs(value(row)); }));
}

void add_difference(const QuestionTable& table, std::size_t a, std::size_t b, std::vector<Fact>& facts)
{
    add_size(
        fmt::format("{} - {}", table.names[b], table.names[a]), table, [&](const auto& row) { return row[b] - row[a]; },
        facts);
}

/// Numbers that stand for themselves: no words, no counts of lists, no parts of vectors and matrices. Of all numbers
/// there are facts, before all others.
std::vector<std::size_t> plain_numbers(const QuestionTable& table, const std::vector<Fact>& facts)
{
    std::vector<std::size_t> plain;
    for (std::size_t i = 0; i < std::min(table.names.size(), table.answers); ++i) {
        const Fact& fact = facts[i];
        const bool is_of_list = is_extreme_of_list(fact) || is_length_of_lists(fact) || fact.words.ends_with("()") ||
                                fact.words.starts_with("the number of");
        if (!fact.component && fact.value_names.empty() && !is_of_list) plain.push_back(i);
    }
    return plain;
}

/// Of what lies in one struct.
void add_differences(const QuestionTable& table, const std::vector<VectorColumns>& vectors,
                     const std::vector<std::size_t>& plain, std::vector<Fact>& facts)
{
    const auto belong = [](std::string_view a, std::string_view b) {
        return !owner_of(a).empty() && owner_of(a) == owner_of(b) && quantity_of(a) == quantity_of(b);
    };
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (std::size_t j = i + 1; j < std::min(vectors.size(), i + most_together); ++j) {
            const VectorColumns& a = vectors[i];
            const VectorColumns& b = vectors[j];
            if (a.size != b.size || b.first >= table.answers || !belong(a.words, b.words)) continue;
            if (quantity_of(a.words) != Quantity::unknown) continue;
            for (std::size_t k = 0; k < a.size; ++k) add_difference(table, a.first + k, b.first + k, facts);
        }
    for (std::size_t i = 0; i < plain.size(); ++i)
        for (std::size_t j = i + 1; j < std::min(plain.size(), i + most_together); ++j)
            if (belong(table.names[plain[i]], table.names[plain[j]])) add_difference(table, plain[i], plain[j], facts);
}

void add_shortest_and_longest(const QuestionTable& table, const std::vector<VectorColumns>& vectors,
                              std::vector<Fact>& facts)
{
    std::vector<VectorColumns> all;
    std::vector<std::string> names;
    for (const VectorColumns& one : vectors) {
        if (one.first >= table.answers || quantity_of(one.words) == Quantity::light) continue;
        all.push_back(one);
        names.push_back(one.words);
    }
    if (all.size() < 2 || all.size() > most_together) return;
    const auto add = [&](std::string_view words, const auto& best) {
        const auto length = [&](const std::vector<double>& row) {
            double square = dot(row, all.front(), all.front());
            for (const VectorColumns& one : all) square = best(square, dot(row, one, one));
            return std::sqrt(square);
        };
        facts.push_back(told_fact(std::string(words) + joined_with_and(names), Fact::Kind::size, table, length));
        facts.back().quantity = Quantity::unknown;
    };
    add(length_of_shortest, [](double a, double b) { return std::min(a, b); });
    add(length_of_longest, [](double a, double b) { return std::max(a, b); });
}

}

void add_sizes(const QuestionTable& table, const std::vector<VectorColumns>& vectors, std::vector<Fact>& facts)
{
    const std::vector<std::size_t> plain = plain_numbers(table, facts);
    // Whatever the numbers are: which facts there are must follow from names alone, so that other questions have the
    // same.
    for (const std::size_t i : plain)
        add_size(
            table.names[i], table, [i](const auto& row) { return row[i]; }, facts);
    add_differences(table, vectors, plain, facts);
    add_shortest_and_longest(table, vectors, facts);
}

}
