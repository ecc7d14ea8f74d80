#pragma once

#include <string_view>
#include <vector>

#include "question/facts.hpp"

namespace umbral::grader {

/// So begin the words of the last two that add_sizes() adds.
inline constexpr std::string_view length_of_shortest = "the length of the shortest of ";
inline constexpr std::string_view length_of_longest = "the length of the longest of ";

/// Adds how large numbers are without their signs, how far numbers of one struct lie apart, coordinate by coordinate,
/// and how long the shortest and the longest of all vectors are: what is taken for nothing where it is below a bound.
void add_sizes(const QuestionTable& table, const std::vector<VectorColumns>& vectors, std::vector<Fact>& facts);

}
