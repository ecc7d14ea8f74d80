#pragma once

#include <string_view>
#include <umbral/core/grid.hpp>

#include "model/exercise.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// Is what the check looks at a picture or a buffer, which to_image can show?
[[nodiscard]] inline bool is_picture(const Check& check)
{
    return check.judge == JudgeKind::image || check.judge == JudgeKind::buffer || check.judge == JudgeKind::noise;
}

/// A recorded picture or buffer as people can look at it.
///
/// Bytes of 1, 3 or 4 channels as they are (one is grey); floats linearly so that check.range_low is black and range_high white (one
/// channel, as of a depth buffer, is grey), encoded as sRGB if the judge is `noise`, since they are light; values beyond clamped, NaN magenta; whole numbers of one channel as one colour an id, 0 black.
/// A cell without value is transparent. Throws std::invalid_argument for another number of channels, another type, an empty range, or bytes that do
/// not fit the shape.
[[nodiscard]] Image to_image(const Tensor& tensor, const Check& check);

/// Yours, the reference and their difference beside each other, and below the worst region of each enlarged eight times, its place
/// framed in the pictures above. The map of differences runs from none (black) to the largest that occurs, which the legend names.
///
/// Pictures of different or no size are shown with a sentence that says so instead of a difference. Small pictures are enlarged and
/// large ones thinned out by a whole factor, the largest difference of each block kept, so that the result stays within about 4000 x 2000 pixels.
/// `expected_side` is what is written over the second picture. With JudgeKind::noise, the means of tiles are compared instead of pixels.
[[nodiscard]] Image triptych(const Image& yours, const Image& reference, std::string_view expected_side = "reference", JudgeKind judge = JudgeKind::image);

}
