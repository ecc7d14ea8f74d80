#pragma once

#include <umbral/core/grid.hpp>

#include "model/exercise.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// A recorded picture or buffer as people can look at it.
///
/// Bytes of 1, 3 or 4 channels as they are (one is grey); floats linearly so that check.range_low is black and
/// range_high white (one channel, as of a depth buffer, is grey), encoded as sRGB if they are light; values beyond
/// clamped, NaN magenta; whole numbers of one channel as one colour an id, 0 black. A cell without value is
/// transparent. Throws std::invalid_argument for another number of channels, another type, an empty range, or bytes
/// that do not fit the shape.
[[nodiscard]] Image to_image(const Tensor& tensor, const Check& check);

}
