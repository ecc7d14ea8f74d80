#pragma once

#include <vector>

#include "question/answer_patterns.hpp"

namespace umbral::grader {

/// What is said of answers whose first five digits are right, in words that follow "every wrong answer".
inline constexpr const char* right_but_for_rounding =
    "is nearly right, to five digits or more: perhaps a number is rounded on the way (float, a constant of few "
    "digits), nearly equal ones are subtracted, or a little is added";

/// The same where about as much is lost as a float loses, and no more.
inline constexpr const char* right_to_float =
    "is right to six or seven digits, as many as a float holds: perhaps something is computed or kept in float that "
    "needs double";

/// The same of answers of which fewer are right: rounding once to float does not do that.
inline constexpr const char* roughly_right =
    "is nearly right, and off by more than rounding to float makes: perhaps something is approximated or ends early (a "
    "search, a series), a constant has few digits, nearly equal numbers are subtracted, or a little is added";

/// What is said where most wrong answers are so and some are far off, in words that follow "most wrong answers".
inline constexpr const char* mostly_nearly_right =
    "are nearly right and some are far off: perhaps a number is rounded or cut off on the way, nearly equal ones are "
    "subtracted, or what is nearly 0 is divided by";

/// Are all these wrong answers the right ones but for little: a hundredth of the largest number of the vector, or of
/// the matrix's column, and of each number itself in rows that hold different things? Of codes and counts, which are
/// whole, none is nearly right. Answers must have as many numbers as the right ones, all finite. Then one of the
/// texts above; else null.
[[nodiscard]] const char* nearly_right(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong);

/// Are so at least two of three of them, eight or more? The others may be anything.
[[nodiscard]] bool are_mostly_nearly_right(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong);

}
