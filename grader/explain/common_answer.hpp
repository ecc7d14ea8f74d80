#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "explain/other_cases.hpp"
#include "explain/samples.hpp"

namespace umbral::grader {

/// What all wrong answers share (question/answer_patterns.hpp), or the lists that they are together, if it is so with
/// fresh inputs too, so many that a chance would have shown, and in other cases. Without words if nothing is known.
[[nodiscard]] AnswerPattern common_answer(OtherCases& others, Samples& samples);

/// Do all wrong answers share this pattern with the inputs of this seed too? Nothing if that cannot be said, as where
/// too few are wrong there.
[[nodiscard]] std::optional<bool> holds_at(Worker& worker, const AskedCheck& asked, const std::string& pattern,
                                           std::uint64_t seed);

}
