#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace umbral::grader {

/// Calls of one function, in the order in which they were made.
struct CallsOfFunction {
    std::vector<std::string> names;      ///< of the numbers in its arguments, in words: "ray.origin.x"
    std::vector<std::size_t> arguments;  ///< which argument each is a part of
    std::vector<bool> are_words;         ///< does it stand for a word, "false" or an enumerator, and is no number?
    std::vector<std::vector<std::vector<double>>> runs;  ///< for each run of a case the numbers in each call
};

/// Something that calls never are, or hardly ever.
struct InputGap {
    std::string what;                ///< "never 0", "never equal"
    std::vector<std::string> where;  ///< numbers or arguments; behind one that is so at times stands how often it is
};

/// What is not asked of a function, or in less than a hundredth of its calls (and less than ten): numbers that are 0,
/// 1, negative, between 0 and 1, or broken; coordinates that are 0 while others of their vector are not; vectors that
/// are equal; lists of no, one or two elements, or with equal ones; and, in calls one after the other, the same
/// argument beside others (code that keeps an answer by that alone is right otherwise), or another argument beside the
/// same others (code that keeps an answer by those). Whether a unit's statement allows it, only its author knows.
[[nodiscard]] std::vector<InputGap> input_gaps(const CallsOfFunction& calls);

}
