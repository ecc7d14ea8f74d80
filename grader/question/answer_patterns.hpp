#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "model/named_rows.hpp"
#include "question/answer_pattern.hpp"
#include "question/facts.hpp"

namespace umbral::grader {

/// A student's answer beside the right one: rows of numbers, one after the other; none where nothing was found.
struct AnswerPair {
    std::vector<double> yours;
    std::vector<double> expected;
    bool wrong = false;
    bool refused = false;  ///< the student's code refused the question, and `yours` is empty
};

/// The answers to several questions.
struct AnswerTable {
    std::size_t components = 1;          ///< numbers in a row
    std::size_t keys = 0;                ///< of them, the first ones: what the row is about, and not what it says
    std::vector<std::string> columns{};  ///< what they are called; empty if there is only one
    std::vector<AnswerPair> answers{};
    std::vector<Fact> facts{};  ///< what is told of the questions, in the same order; may be empty
    bool picture = false;       ///< the answers are a picture's cells: what is equal in many of them is its background
    bool several = false;       ///< a question has several of them: the driver, too, may say that one is missing
    std::map<double, NamedRows> kinds{};  ///< of lists of events: what the first number of a row means
};

/// What is said where nothing was answered, in words that follow "every wrong answer".
inline constexpr const char* none_given = "is empty";
inline constexpr const char* all_refused = "is a refusal of what was asked";

/// Of fewer wrong answers anything may be true by chance.
inline constexpr std::size_t least_wrong = 4;

/// Can wrong answers be set beside the right ones, number by number? Not where there are none, or too many, or numbers
/// that are not finite.
[[nodiscard]] bool are_comparable(const AnswerTable& table);

/// What all wrong answers share, each in words that hold for answers to other questions too: "differs in y
/// only", "is 0", "lacks the last row", "is ray.origin", "is the right one to the question before". The most
/// telling first. Of fewer than least_wrong only which numbers of a row differ, and of a single one nothing.
[[nodiscard]] std::vector<AnswerPattern> answer_patterns(const AnswerTable& table);

}
