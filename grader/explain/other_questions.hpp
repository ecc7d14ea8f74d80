#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "explain/explained_checks.hpp"
#include "question/log.hpp"

namespace umbral::grader {

/// The name of a reason begins so if another question was answered.
inline constexpr std::string_view question_reason = "question: ";

/// Are the student's wrong results the reference's right ones to other questions: an angle negated, two arguments
/// exchanged, a list in reverse? Each kind of question is asked of the reference in all calls of its function, and its
/// recording weighed as a known mistake's is. Nobody writes anything for this: the questions follow from the types of
/// the arguments that the driver passes through ask().
[[nodiscard]] std::vector<Explanation> by_other_questions(Worker& worker, const Exercise& exercise,
                                                          std::span<const CaseChecks> groups);

}
