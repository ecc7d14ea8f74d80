#pragma once

#include <optional>
#include <string>
#include <vector>

#include "question/conditions.hpp"

namespace umbral::grader {

/// Rows that came of a question and rows that were expected of it, in any order.
struct RowsOfCall {
    std::vector<std::vector<double>> yours{};
    std::vector<std::vector<double>> expected{};
};

/// Rows of one side beside each other: what is told of each, and which have no partner on the other side.
struct ToldRows {
    std::vector<Fact> facts{};
    std::vector<bool> alone{};
};

enum class Side { yours, expected };

/// For each row whether none is left for it among the others: each has an equal one of its own, or none.
[[nodiscard]] std::vector<bool> without_partner(const std::vector<std::vector<double>>& rows,
                                                const std::vector<std::vector<double>>& others);

/// What is told of the rows of a side: their numbers, called by `names`, one for each number of a row. A row's partner
/// is an equal one of the same call, for each its own.
[[nodiscard]] ToldRows told_rows(const std::vector<RowsOfCall>& calls, Side side,
                                 const std::vector<std::string>& names);

/// The simplest condition on a row's own numbers that parts those without a partner from the others: on one number, or
/// two beside each other, without a bound that was put between these very rows.
[[nodiscard]] std::optional<Condition> condition_of_alone(const ToldRows& rows);

/// "a row is lacking wherever edge.a is 0 (6 of 6), and there everywhere else (30 of 30)"
[[nodiscard]] std::string sentence_of_alone(Side side, const Condition& condition);

}
