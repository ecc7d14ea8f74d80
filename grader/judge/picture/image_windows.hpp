#pragma once

#include <cstdint>
#include <vector>

#include "judge/picture/picture.hpp"

namespace umbral::grader {

/// Side of the windows in which faults are looked for that are too small to count in the whole picture; they overlap by
/// half.
inline constexpr int window_side = 16;

/// The window of window_side x window_side pixels that holds most marked ones.
struct DensestWindow {
    int count = 0;
    int x = 0;  ///< left …
    int y = 0;  ///< … and top of the window
};

/// `marks` holds 0 or 1 a pixel, row by row.
[[nodiscard]] DensestWindow densest_window(const std::vector<std::uint8_t>& marks, int width, int height);

/// The window whose surface has the most different mean.
struct LevelWindow {
    double difference = 0;  ///< yours less expected, of the worst channel, in levels
    double level = 0;       ///< expected mean there
    double ratio = 0;       ///< to the threshold (thresholds::window_levels, window_share)
    int x = 0;
    int y = 0;
};

/// Of the windows with at least thresholds::window_pixels pixels in `mask` (0 or 1 a pixel); only those pixels count.
[[nodiscard]] LevelWindow worst_level_window(const Picture& student, const Picture& expected,
                                             const std::vector<std::uint8_t>& mask);

}
