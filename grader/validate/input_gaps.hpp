#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace umbral::grader {

/// One of the numbers in a function's arguments.
struct AskedNumber {
    std::string name;               ///< in words: "ray.origin.x"
    std::size_t argument = 0;       ///< in which one it is
    bool is_word = false;           ///< it stands for a word, "false" or an enumerator
    bool is_of_whole_list = false;  ///< the least number in a list, or how many are different
};

/// Calls of one function, in the order in which they were made.
struct CallsOfFunction {
    std::vector<AskedNumber> numbers;
    std::vector<std::vector<std::vector<double>>> runs;  ///< for each run of a case the numbers in each call
};

/// Something that calls never are, or hardly ever.
struct InputGap {
    std::string what;                ///< "never 0", "never equal"
    std::vector<std::string> where;  ///< numbers or arguments; behind one that is so at times stands how often it is
};

/// What is not asked of a function, or in less than a hundredth of its calls (and less than ten): numbers that are 0,
/// negative, between 0 and 1, or broken; coordinates that are 0 while others of their vector are not; vectors that are
/// equal; lists of less than four elements, or with equal ones; and, in calls one after the other, the same argument
/// beside others (code that keeps an answer by that alone is right otherwise), or another argument beside the same
/// others (code that keeps an answer by those); of a function with one argument, its parts. Whether a unit's statement
/// allows it, only its author knows.
[[nodiscard]] std::vector<InputGap> input_gaps(const CallsOfFunction& calls);

}
