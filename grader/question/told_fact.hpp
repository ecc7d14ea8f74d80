#pragma once

#include <string>
#include <utility>
#include <vector>

#include "question/facts.hpp"

namespace umbral::grader {

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
