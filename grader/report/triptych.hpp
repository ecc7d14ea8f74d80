#pragma once

#include <string_view>
#include <umbral/core/grid.hpp>

#include "judge/image/rule.hpp"

namespace umbral::grader {

/// Yours, the reference and their difference beside each other, and below the worst region of each enlarged eight
/// times, its place framed in the pictures above. The map of differences runs from none (black) to the largest that
/// occurs, which the legend names.
///
/// Pictures of different or no size are shown with a sentence that says so instead of a difference. Small pictures are
/// enlarged and large ones thinned out by a whole factor, the largest difference of each block kept, so that the result
/// stays within about 4000 x 2000 pixels. `expected_side` is what is written over the second picture. They are compared
/// as `judge` compares them: the noise of light, by the means of tiles.
[[nodiscard]] Image triptych(const Image& yours, const Image& reference, std::string_view expected_side = "reference",
                             const JudgeKind& judge = image_kind());

}
