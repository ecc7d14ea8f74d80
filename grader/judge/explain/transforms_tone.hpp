#pragma once

#include <vector>

#include "judge/explain/explain.hpp"

namespace umbral::grader {

/// Named transforms of a picture's levels: gamma, light, inversion. Since clamping and rounding lose levels, they are
/// not undone but recognised: where the student's value is what the error makes of the expected one (within 1.5 of 255
/// levels), it is replaced by that.
[[nodiscard]] std::vector<NamedTransform> tone_transforms();

/// One of 255 levels, in the numbers of this picture: 1 where they are codes, 1 / 255 where they are fractions.
[[nodiscard]] double one_level_of(const Tensor& tensor);

}
