#pragma once

#include <vector>

#include "question/possible_conditions.hpp"

namespace umbral::grader {

/// Of conditions that say the same, the one about the question's own numbers is said: how far-fetched one about this
/// number is.
[[nodiscard]] int cost_of(const Fact& fact);

/// Is it the least or the largest number of a whole list? Whichever that is, it is hardly ever the reason.
[[nodiscard]] bool is_extreme_of_list(const Fact& fact);

/// Is it how long the lists of a list are? Other numbers equal that by chance.
[[nodiscard]] bool is_length_of_lists(const Fact& fact);

/// Adds conditions on fact `i` that need no bound: names, signs, zero, one, not finite, ties, odd and even.
void add_plain(const std::vector<Fact>& facts, std::size_t i, std::vector<PossibleCondition>& all);

/// Adds, of a number of which there are several whole ones, that it is the one with which answers are wrong: "face is
/// 3". Of 0 and 1 add_plain() says it.
void add_single_value(const std::vector<Fact>& facts, std::size_t i, const std::vector<bool>& wrong,
                      std::vector<PossibleCondition>& all);

}
