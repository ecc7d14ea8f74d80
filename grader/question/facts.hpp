#pragma once

#include <optional>
#include <string>
#include <vector>

#include "question/log.hpp"
#include "question/quantity.hpp"

namespace umbral::grader {

/// A number that can be told of each of several questions, in words: "the length of ray.direction".
struct Fact {
    /// What may be compared: numbers of the question itself, lengths and distances with each other, products of vectors
    /// and their coordinates with 0 or a bound, sizes with a bound only. A tie is how many coordinates are as large as
    /// the largest, beside it.
    enum class Kind { number, length, product, parallel, coordinate, tie, size };

    std::string words;
    Kind kind = Kind::number;
    bool component = false;                  ///< one of a vector's: of less interest than the vector
    bool answer = false;                     ///< of the right answer, and not of the question
    bool first = false;                      ///< said before all others that part alike
    bool label = false;                      ///< says which row of a table it is
    std::vector<double> values{};            ///< for each question
    std::vector<std::string> value_names{};  ///< what 0, 1, … mean: {"false", "true"}; none of a number that is one
    Quantity quantity = Quantity::unknown;   ///< what it measures, by its words
};

/// Questions of one kind beside each other, in their order: `numbers[i]` are the features of question i, `names` what
/// they are called in words.
struct QuestionTable {
    std::vector<std::string> names;
    std::vector<std::vector<double>> numbers;
    std::size_t answers = static_cast<std::size_t>(-1);  ///< from this number on they are of the right answer
    std::vector<std::vector<std::string>> words{};       ///< as QuestionKind::words; fewer: the others have none
    std::optional<std::size_t> first{};  ///< the number that is the best reason, of several that part alike
    std::vector<std::size_t> labels{};   ///< numbers behind `answers` that are no answer: which row it is
};

/// Numbers that are a vector together: "ray.origin", from the third on, 3 of them.
struct VectorColumns {
    std::string words;
    std::size_t first = 0;
    std::size_t size = 0;
};

/// The vectors among numbers that are called so: "ray.origin.x", "ray.origin.y" …
[[nodiscard]] std::vector<VectorColumns> vectors_in(const std::vector<std::string>& names);

/// All that is told of the questions: their numbers, the lengths, least and largest coordinates of vectors and ties
/// between these, distances and products between two, areas and determinants of three, determinants of matrices, and
/// sizes (size_facts.hpp).
[[nodiscard]] std::vector<Fact> facts_of(const QuestionTable& table);

}
