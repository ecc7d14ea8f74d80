#pragma once

#include <string>
#include <vector>

#include "question/log.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// Does the question leave out calls, or elements of lists?
[[nodiscard]] bool leaves_out(const OtherQuestion& question);

/// Questions that are simpler than the log's, and still questions: with something in calls of `function`, or of what
/// its objects were made or changed by, taken as 0 or 1, left out, equal to something else. The likeliest first.
[[nodiscard]] std::vector<OtherQuestion> simpler_questions(const QuestionLog& log, const std::string& function,
                                                           const std::string& headers);

/// How much the right answers change, as a share of their size; 1 where the two tables are not of one form.
[[nodiscard]] double share_changed(const Tensor& before, const Tensor& after);

/// Is there about as much to be answered right as there was, with the change? Not where a count taken as 0 leaves
/// nothing of a list.
[[nodiscard]] bool leaves_answers(const OtherQuestion& change, const Tensor& before, const Tensor& after);

}
