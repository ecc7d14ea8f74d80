#pragma once

#include <cstddef>

#include "explain/asked_answers.hpp"

namespace umbral::grader {

/// Of tables of many rows to a question: is this number of each row right whatever else is wrong, and several whole
/// ones? Then it says which row it is.
[[nodiscard]] bool is_label(const AskedAnswers& answers, std::size_t component);

}
