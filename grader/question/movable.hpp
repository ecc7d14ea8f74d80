#pragma once

#include <string>
#include <vector>

#include "question/log.hpp"

namespace umbral::grader {

/// The moves of a function's arguments (QuestionLog::moves) that leave its questions questions: of what has length 1 in
/// all of them, as directions, quaternions and the columns of turns, only moves that keep the length, and of the
/// vectors of a frame and of a matrix's entries that are 0 or 1 in all of them none.
[[nodiscard]] std::vector<OtherQuestion> movable(const QuestionLog& log, const std::string& function);

/// Is what the question changes, or something that it is a part of, of length 1 in all calls, as directions are?
[[nodiscard]] bool is_of_unit_length(const QuestionLog& log, const OtherQuestion& question);

}
