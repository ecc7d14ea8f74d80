#pragma once

#include <optional>
#include <string>

#include "explain/asked_answers.hpp"
#include "explain/asked_sample.hpp"
#include "question/conditions.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

/// A condition that parts wrong answers from right ones, or questions with wrong answers from those without.
struct CommonCondition {
    Condition condition;
    ToldSample AskedSample::*of;  ///< by_answer or by_question: what it takes the facts of
};

/// What the wrong answers of a check have in common.
struct InCommon {
    std::optional<CommonCondition> condition{};  ///< the simplest one
    /// What all wrong answers share (question/answer_patterns.hpp): "is 0"; without words if nothing is known.
    AnswerPattern answer{};
};

/// Holds only what is so on fresh inputs too, or where there can be no others. Of a hidden case only fresh inputs are
/// asked, which are the same for everybody: nothing is told of those that were graded. Takes as much of `time`, which
/// all checks of a unit share, as its runs need; nothing where none is left.
[[nodiscard]] InCommon find_in_common(Worker& worker, const AskedCheck& asked, SpareTime& time);

/// "wrong wherever ray.t_min is positive (50 of 50), right everywhere else (350 of 350); every wrong answer is 0".
/// Without words if there is neither; it tells what the answers' pattern does where that is all that it says.
[[nodiscard]] AnswerPattern sentence_of(const InCommon& common);

/// Does the condition part wrong answers from right ones with the inputs of this seed too? Nothing if that cannot be
/// said, as where none or all are wrong there.
[[nodiscard]] std::optional<bool> holds_at(Worker& worker, const AskedCheck& asked, const CommonCondition& condition,
                                           std::uint64_t seed);

}
