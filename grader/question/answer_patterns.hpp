#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "question/facts.hpp"

namespace umbral::grader {

/// A student's answer beside the right one: rows of numbers, one after the other; none where nothing was found.
struct AnswerPair {
    std::vector<double> yours;
    std::vector<double> expected;
    bool wrong = false;
};

/// The answers to several questions.
struct AnswerTable {
    std::size_t components = 1;          ///< numbers in a row
    std::size_t keys = 0;                ///< of them, the first ones: what the row is about, and not what it says
    std::vector<std::string> columns{};  ///< what they are called; empty if there is only one
    std::vector<AnswerPair> answers{};
    std::vector<Fact> facts{};  ///< what is told of the questions, in the same order; may be empty
};

/// Of fewer wrong answers anything may be true by chance.
inline constexpr std::size_t least_wrong = 4;

/// What all wrong answers share, each in words that hold for answers to other questions too: "differs in y
/// only", "is always 0", "lacks the last row", "is ray.origin", "is the right one to the question before". The most
/// telling first. Of fewer than least_wrong only which numbers of a row differ, and of a single one nothing.
[[nodiscard]] std::vector<std::string> answer_patterns(const AnswerTable& table);

}
