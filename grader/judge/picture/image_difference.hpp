#pragma once

#include <optional>
#include <umbral/core/grid.hpp>

#include "model/exercise.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// A rectangle of pixels; x and y are its left and top ones.
struct Window {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend bool operator==(const Window&, const Window&) = default;
};

/// Where two pictures differ.
struct WorstRegion {
    Window bounds;   ///< the smallest rectangle that holds every differing pixel
    Window worst;    ///< the window of 32 x 32 (less in a smaller picture) with the largest sum of differences
    int peak_x = 0;  ///< the pixel that differs most inside it, the first if there are several
    int peak_y = 0;
};

/// How far each pixel lies from the expected one: the largest difference over the channels, 0 .. 255 levels of the
/// check's range for pictures; for buffers, 255 where cells differ (measured buffers: in proportion to the span of the
/// finite expected values). Where a value is absent or not finite on one side, 255. Of noise, the means of tiles are
/// compared (noise_map). Throws std::invalid_argument if the two cannot be compared (another shape or type).
[[nodiscard]] Grid<std::uint8_t> difference_map(const Check& check, const Tensor& student, const Tensor& expected);

/// Where the two differ most; nothing if they do not.
[[nodiscard]] std::optional<WorstRegion> worst_region(const Check& check, const Tensor& student,
                                                      const Tensor& expected);

}
