#pragma once

#include <string>

#include "judge/picture/image_rule.hpp"

namespace umbral::grader {

/// What is wrong with a picture that the rule does not pass, in half a sentence: the worst of its measures, said of
/// where most of it lies.
[[nodiscard]] std::string complaint(const ImageRule& rule);

}
