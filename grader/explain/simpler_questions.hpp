#pragma once

#include <string>
#include <vector>

#include "question/log.hpp"

namespace umbral::grader {

/// Does the question leave out calls, or elements of lists?
[[nodiscard]] bool leaves_out(const OtherQuestion& question);

/// Questions that are simpler than the log's, and still questions: with something in calls of `function`, or of what
/// its objects were made or changed by, taken as 0 or 1, left out, equal to something else. The likeliest first.
[[nodiscard]] std::vector<OtherQuestion> simpler_questions(const QuestionLog& log, const std::string& function,
                                                           const std::string& headers);

}
