#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "explain/asked_answers.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

/// What makes all wrong answers of a check right when it is so in all questions: parts of the arguments taken as 0,
/// lists cut, calls and events left out and the like. Found by asking the student's code and the reference again; of a
/// hidden case with practice inputs only. None if there is nothing of that kind, or only what leaves hardly anything to
/// be answered. One or two, what changes the right answers least in front. Its runs take from `time`.
[[nodiscard]] std::vector<OtherQuestion> changes_that_make_right(Worker& worker, const AskedCheck& asked,
                                                                 SpareTime& time);

inline constexpr std::string_view right_with_words = "asked with ";

/// "asked with material.specular taken as 0, your answers are right"; empty if there are no such changes.
[[nodiscard]] std::string right_with(const std::vector<OtherQuestion>& changes, const std::string& headers);

/// Does the change make the wrong answers to the inputs of a seed right? Nothing where none is wrong.
[[nodiscard]] std::optional<bool> is_right_with(Worker& worker, const AskedCheck& asked, std::uint64_t seed,
                                                const OtherQuestion& change, SpareTime& time);

}
