#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "question/facts.hpp"

namespace umbral::grader {

/// A condition that parts questions with wrong answers from those with right ones.
struct Condition {
    std::string words;  ///< of a question for which it holds: "ray.t_min is greater than 0"
    /// Does it hold? Takes facts of other questions of the same kind, and which of them to look at.
    std::function<bool(const std::vector<Fact>& facts, std::size_t question)> holds;
    /// Does it hold a bound, put between these very questions, and is this question nearer to it than all of them, so
    /// that nobody knows? Empty: of none.
    std::function<bool(const std::vector<Fact>& facts, std::size_t question)> undecided{};
    bool fitted = false;     ///< holds a bound that was put between these very questions
    bool of_answer = false;  ///< tells of the right answer's numbers, and not of the question's alone
    bool one_sided = false;  ///< answers are wrong only where it holds, but not all of these (one_sided.hpp)
    bool is_simple = false;  ///< tells of one number, length or sign in the question, and of no bound of its own
    std::optional<std::size_t> fact{};  ///< the only one that it looks at, if it is one
    bool compares = false;              ///< sets two numbers of the question beside each other
    /// Other numbers of the questions by which these are told apart alike: what the reason is, they do not show.
    std::vector<std::string> also_told_by{};
    std::size_t wrong = 0;        ///< questions with wrong answers …
    std::size_t wrong_where = 0;  ///< … and those of them for which it holds
    std::size_t right = 0;
    std::size_t right_where = 0;  ///< right answers for which it holds
};

struct PossibleCondition;

/// The condition, and for how many of these questions it holds.
[[nodiscard]] Condition measured(const PossibleCondition& candidate, const std::vector<Fact>& facts,
                                 const std::vector<bool>& wrong);

/// How well a condition must part: the share of wrong answers for which it holds, and of right ones for which it does
/// not.
inline constexpr double least_parted = 0.97;

/// Does `condition` part these questions, but those that are undecided, so well? One that is one-sided must hold of all
/// wrong ones.
[[nodiscard]] bool parts(const Condition& condition, const std::vector<Fact>& facts, const std::vector<bool>& wrong);

/// The simplest condition on the facts that parts the questions for which `wrong` is true from the others; the same of
/// two or three numbers joined by "or", or any two joined by "and", where no single one does. Nothing if none does so
/// nearly everywhere, or if there are fewer than four of either: so few are parted by chance.
[[nodiscard]] std::optional<Condition> simplest_condition(const std::vector<Fact>& facts,
                                                          const std::vector<bool>& wrong);

/// "wrong wherever ray.t_min is greater than 0 (201 of 201), right everywhere else (201 of 201)", and what tells them
/// apart as well. "wrong only where …" if it is one-sided.
[[nodiscard]] std::string sentence_of(const Condition& condition);

}
