#pragma once

#include <cstddef>
#include <vector>

#include "question/log.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// How much the right answers change, as a share of their size; 1 where the two tables are not of one form.
[[nodiscard]] double share_changed(const Tensor& before, const Tensor& after);

/// Are these rows of right answers all empty after a change, where some were not, or all there where none was?
[[nodiscard]] bool settles_presence(const Tensor& before, const Tensor& after, const std::vector<std::size_t>& rows);

/// Is there about as much to be answered right as there was, with the change? Not where a count taken as 0 leaves
/// nothing of a list.
[[nodiscard]] bool leaves_answers(const OtherQuestion& change, const Tensor& before, const Tensor& after);

/// Of so many answers so many were wrong: would any other questions in their place lead to right ones, because nearly
/// all do?
[[nodiscard]] bool are_right_by_chance(std::size_t asked, std::size_t wrong);

}
