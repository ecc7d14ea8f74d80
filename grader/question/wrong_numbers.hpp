#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "question/answer_patterns.hpp"
#include "question/answer_relations.hpp"

namespace umbral::grader {

// Wrong answers that are as long as the right ones, number by number.

/// Numbers of all wrong answers beside the right ones.
struct NumberPairs {
    std::vector<double> yours;
    std::vector<double> right;
};

/// Those in these places of each row; of lists only of the rows that are wrong.
[[nodiscard]] NumberPairs numbers_in(const std::vector<const AnswerPair*>& wrong, std::size_t components,
                                     const std::vector<std::size_t>& which);

/// Where each answer is one row: which question it answers. Nothing where one is not.
[[nodiscard]] std::vector<std::size_t> questions_of(const AnswerTable& table,
                                                    const std::vector<const AnswerPair*>& wrong);

/// So many numbers of each row, from this one on, as vectors; none where an answer is not one row.
[[nodiscard]] WrongVectors wrong_vectors(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong,
                                         std::size_t first, std::size_t count);

/// What each wrong number in this place of a row is: "the right one plus 1", "the right y" by these names of columns.
[[nodiscard]] std::optional<AnswerPattern> change_of(const AnswerTable& table,
                                                     const std::vector<const AnswerPair*>& wrong, std::size_t component,
                                                     const std::vector<std::string>& columns);

/// Of several wrong numbers of each row: "2 times as far from box as the right one" (distance_relation.hpp).
[[nodiscard]] std::optional<std::string> distance_of(const AnswerTable& table,
                                                     const std::vector<const AnswerPair*>& wrong,
                                                     const std::vector<std::size_t>& which,
                                                     const std::vector<std::string>& columns);

/// Where the wrong numbers of each row are some of those that have a name together, as a colour's: whose right ones
/// they are, "the right diffuse".
[[nodiscard]] std::optional<std::string> of_another_name(const AnswerTable& table,
                                                         const std::vector<const AnswerPair*>& wrong,
                                                         const std::vector<std::size_t>& which,
                                                         const std::vector<std::string>& columns);

}
