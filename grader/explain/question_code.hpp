#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "question/log.hpp"

namespace umbral::grader {

/// Those of the questions behind a value that are shown: all, or the first and the last.
[[nodiscard]] std::vector<std::uint32_t> shown_of(const QuestionSpan& span);

/// The questions behind a value below each other; where more than one led to it, how many is said. A call of an object
/// begins with how it was made: what stands in a later question so is not said before. Empty unless `code` has all that
/// are shown.
[[nodiscard]] std::string together(const QuestionSpan& span, const std::map<std::uint32_t, std::string>& code);

}
