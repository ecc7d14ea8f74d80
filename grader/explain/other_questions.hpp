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

/// The text of the headers where a unit's parameters have names: its own first, since other units' functions may have
/// the names of its own, then the rest of its topic's.
[[nodiscard]] std::string interface_text(const Worker& worker, const Exercise& exercise);

/// Are the student's wrong results the reference's right ones to other questions: an angle negated, two arguments
/// exchanged, a list in reverse? Each kind of question is asked of the reference in all calls of its function, and its
/// recording weighed as a known mistake's is. Nobody writes anything for this: the questions follow from the types of
/// the arguments that the driver passes through ask().
[[nodiscard]] std::vector<Explanation> by_other_questions(Worker& worker, const Exercise& exercise,
                                                          std::span<const CaseChecks> groups);

}
