#pragma once

#include <cstdint>
#include <string>

#include "build/submission.hpp"
#include "question/log.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// What is said of a check whose first wrong value is right then.
inline constexpr const char* right_alone =
    "this call is answered right if no other is made before it: your code keeps something from one call to the next, "
    "perhaps in a static or a global variable";

/// The same where OpenGL keeps something, too. It begins with right_alone.
[[nodiscard]] inline std::string right_alone_of(const Exercise& exercise)
{
    return exercise.gl_calls ? std::string(right_alone) + ", or in OpenGL's state" : right_alone;
}

/// Was it found that something is kept from one call to the next, so that no other question shows anything?
[[nodiscard]] inline bool keeps_something(const CheckResult& result)
{
    return result.beside || result.common.starts_with(right_alone);
}

/// What is said of a check that is right unless other questions are asked in between (unit/beside_itself.hpp).
inline constexpr const char* right_without_others =
    "all of this is answered right if nothing else is asked in between: your code keeps something from one call to the "
    "next, perhaps in a static or a global variable, or takes two objects for one";

inline constexpr const char* crashes_beside_others =
    "all of this is answered right if nothing else is asked in between, and crashes otherwise: your code keeps "
    "something from one call to the next, perhaps in a static or a global variable";

/// May a case's run be repeated for what is said beside the grade? Not if it took half of what it may, nor when the
/// time for such runs is used up.
[[nodiscard]] inline bool may_repeat(Worker& worker, const Exercise& exercise, const CaseResult& one)
{
    return worker.spare_time().is_left() && one.student.wall_seconds <= exercise.limits.wall_seconds / 2;
}

/// A row of the table of a case that is asked whole, and the question that led to it.
struct AskedRow {
    const QuestionLog& log;
    std::uint32_t question = 0;
    std::size_t row = 0;
};

/// Is a row of a check right in a run that asked only the question behind it, of a case which `expected` asked whole,
/// and each other row of that question as well?
[[nodiscard]] bool is_row_right(const Check& check, const RunOutcome& run, const Expected& expected,
                                const AskedRow& asked);

/// Nothing is asked but this question.
[[nodiscard]] inline PassedOver only(std::uint32_t question) { return {.end = question + 1, .only = question}; }

/// Is a row of a check, which a student's code gets wrong, right if its question is the only one of the case that is
/// asked? Questions to objects that earlier ones made, or with arguments that follow from earlier answers, cannot be
/// asked so: no. A run of the case, and another of the trusted solution's.
[[nodiscard]] bool is_right_alone(Worker& worker, const Exercise& exercise, const Built& built, const Check& check,
                                  const CaseResult& one, std::uint32_t question, std::size_t row);

}
