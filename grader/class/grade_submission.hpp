#pragma once

#include <functional>

#include "class/submission_parts.hpp"
#include "worker/crew.hpp"

namespace umbral::grader {

/// Grades what is missing or changed of a submission, on all workers of the crew, keeps each unit's result as soon as
/// it is there, and writes its reports. What the student did never throws, and trouble of ours while grading is a
/// unit's verdict; throws std::exception with the reason if results or reports cannot be written, RefusedFolder if
/// their place is taken. `graded` is called after each unit that was graded, by one worker at a time.
[[nodiscard]] Graded grade_submission(Crew& crew, const SubmissionPlan& plan, const SubmissionFolder& submission,
                                      const std::function<void()>& graded);

}
