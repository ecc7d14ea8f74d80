#pragma once

#include <string>
#include <vector>

#include "question/conditions.hpp"

// Where made-up questions are answered wrongly, and what is said of that.
namespace umbral::grader {

template <class Test>
std::vector<bool> wrong_where(const QuestionTable& table, const Test& test)
{
    std::vector<bool> wrong;
    for (const std::vector<double>& row : table.numbers) wrong.push_back(test(row));
    return wrong;
}

inline std::string words(const QuestionTable& table, const std::vector<bool>& wrong)
{
    const auto condition = simplest_condition(facts_of(table), wrong);
    return condition ? condition->words : "nothing";
}

}
