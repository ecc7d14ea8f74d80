#include "question/lost_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "question/alike.hpp"

namespace umbral::grader {
namespace {

using Rows = std::vector<std::vector<double>>;

}

std::vector<bool> without_partner(const Rows& rows, const Rows& others)
{
    std::vector<bool> taken(others.size());
    std::vector<bool> alone;
    for (const std::vector<double>& row : rows) {
        std::size_t partner = 0;
        while (partner < others.size() && (taken[partner] || !alike_rows(row, others[partner]))) ++partner;
        alone.push_back(partner == others.size());
        if (partner < others.size()) taken[partner] = true;
    }
    return alone;
}

ToldRows told_rows(const std::vector<RowsOfCall>& calls, Side side, const std::vector<std::string>& names)
{
    QuestionTable table;
    table.names = names;
    ToldRows told;
    for (const RowsOfCall& call : calls) {
        const Rows& rows = side == Side::yours ? call.yours : call.expected;
        const std::vector<bool> alone = without_partner(rows, side == Side::yours ? call.expected : call.yours);
        table.numbers.insert(table.numbers.end(), rows.begin(), rows.end());
        told.alone.insert(told.alone.end(), alone.begin(), alone.end());
    }
    told.facts = facts_of(table);
    return told;
}

std::optional<Condition> condition_of_alone(const ToldRows& rows)
{
    std::optional<Condition> condition = simplest_condition(rows.facts, rows.alone);
    if (!condition || condition->fitted || !(condition->fact || condition->compares) ||
        !condition->also_told_by.empty())
        return std::nullopt;
    return condition;
}

std::string sentence_of_alone(Side side, const Condition& condition)
{
    return fmt::format("{} wherever {} ({} of {}), and {} everywhere else ({} of {})",
                       side == Side::expected ? "a row is lacking" : "a row is too much", condition.words,
                       condition.wrong_where, condition.wrong_where + condition.right_where,
                       side == Side::expected ? "there" : "right", condition.right - condition.right_where,
                       condition.right - condition.right_where + condition.wrong - condition.wrong_where);
}

}
