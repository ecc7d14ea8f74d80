#pragma once

#include <string>
#include <utility>
#include <vector>

#include "question/facts.hpp"

namespace umbral::grader {

/// The product of two vectors of a question, which must be of one size.
[[nodiscard]] inline double dot(const std::vector<double>& row, const VectorColumns& a, const VectorColumns& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size; ++i) sum += row[a.first + i] * row[b.first + i];
    return sum;
}

/// A fact of all questions of a table; `value` takes the numbers of one.
template <class Value>
Fact told_fact(std::string words, Fact::Kind kind, const QuestionTable& table, const Value& value)
{
    Fact result{std::move(words), kind};
    for (const std::vector<double>& row : table.numbers) result.values.push_back(value(row));
    result.quantity = quantity_of(result.words);
    return result;
}

}
