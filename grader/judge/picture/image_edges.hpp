#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "judge/picture/picture.hpp"

namespace umbral::grader {

/// The difference of two levels.
[[nodiscard]] inline std::uint8_t apart(std::uint8_t a, std::uint8_t b)
{
    return static_cast<std::uint8_t>(std::max(a, b) - std::min(a, b));
}

/// Least difference of each pixel of a's row `y` to the 3x3 neighbourhood of the same place in b: a pixel's is that of
/// its worst channel. `best`, the result, and `room` hold a row each.
void least_difference(const Picture& a, const Picture& b, int y, std::vector<std::uint8_t>& best,
                      std::vector<std::uint8_t>& room);

/// Rule (a): 1 for each pixel without a similar one in the other picture. The larger of the two directions decides, so
/// that neither a lost nor an added thin line finds an excuse. `difference` is channel_difference of the two.
[[nodiscard]] std::vector<std::uint8_t> edge_errors(const Picture& student, const Picture& expected,
                                                    const std::vector<std::uint8_t>& difference);

}
