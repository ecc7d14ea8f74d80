#pragma once

#include <optional>
#include <span>
#include <string>

#include "question/answer_pattern.hpp"

namespace umbral::grader {

/// A number in words: "ln 2", "pi/180 (degrees to radians)", "2/3", "0.25": the constant that it is, to six digits, if
/// it is one that formulas hold, else the number itself. `remark` says whether what is in brackets is told too.
[[nodiscard]] std::string constant_text(double number, bool remark = true);

/// "ln 2 (as ln is of log2) times the right one", "the right one with the opposite sign".
[[nodiscard]] AnswerPattern multiple(double factor);

/// What each of `yours` is, of the number of `right` in the same place, if it is the same for all: "the right one plus
/// 1", "3 divided by the right one", "the right one without its fraction", "1 minus the right one". Nothing if the
/// right ones are too few different ones to say so.
[[nodiscard]] std::optional<AnswerPattern> change_of_numbers(std::span<const double> yours,
                                                             std::span<const double> right);

/// "what an integer of 32 bits can hold of the right one …". Unlike other changes it is none by chance, also of a
/// single large number.
[[nodiscard]] std::optional<std::string> wrapped_numbers(std::span<const double> yours, std::span<const double> right);

/// "larger than the right one", "smaller than the right one", if all of at least eight are, by more than rounding.
[[nodiscard]] std::optional<std::string> side_of_numbers(std::span<const double> yours, std::span<const double> right);

}
