#pragma once

#include <functional>

#include "batch/submission_parts.hpp"
#include "batch/workshop.hpp"

namespace umbral::grader {

/// Grades what is missing or changed of a submission, keeps each unit's result as soon as it is there, and writes its reports. What the
/// student did never throws, and trouble of ours while grading is a unit's verdict; throws std::exception with the reason if results or
/// reports cannot be written, RefusedFolder if their place is taken. `graded` is called after each unit that was graded.
[[nodiscard]] Graded grade_submission(Workshop& workshop, const SubmissionPlan& plan, const SubmissionFolder& submission, const std::function<void()>& graded);

}
