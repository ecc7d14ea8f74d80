#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "question/facts.hpp"

namespace umbral::grader {

/// Questions with wrong answers are parted from others only where there are so many of each.
inline constexpr std::size_t least_questions = 4;

/// A condition that may be why answers are wrong.
struct PossibleCondition {
    std::string words;
    std::function<bool(const std::vector<Fact>& facts, std::size_t question)> holds;
    int cost = 0;                       ///< how far-fetched: of several that part alike, the cheapest is said
    bool fitted = false;                ///< as in Condition
    bool of_answer = false;             ///< likewise
    std::optional<std::size_t> fact{};  ///< the one that it looks at, if it is one
    bool compares = false;              ///< as in Condition
    std::function<bool(const std::vector<Fact>& facts, std::size_t question)> undecided{};  ///< likewise
    bool accidental = false;  ///< may well hold by chance: a bound between groups of equal numbers, a whole coordinate
};

/// What can be said of one fact, or of two beside each other: signs, zeros, names, bounds between right and wrong
/// answers, which of two is greater.
[[nodiscard]] std::vector<PossibleCondition> possible_conditions(const std::vector<Fact>& facts,
                                                                 const std::vector<bool>& wrong);

}
