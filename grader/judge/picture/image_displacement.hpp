#pragma once

#include <cstdint>
#include <vector>

#include "judge/picture/picture.hpp"

namespace umbral::grader {

/// By how many pixels the student's picture lies to the right of the expected one, and below it.
struct Displacement {
    double x = 0;
    double y = 0;
};

/// The displacement that explains the differences at edges best, in parts of a pixel: the least-squares solution of
/// yours - expected = -(x, y) · gradient over all pixels outside `smooth` (1 where the expected picture is smooth) and
/// all colours. Edge pixels that change hands at random cancel out; a sampling point half a pixel off moves all of them
/// the same way. Based on: B. D. Lucas, T. Kanade. An Iterative Image Registration Technique with an Application to
/// Stereo Vision. 1981.
[[nodiscard]] Displacement edge_displacement(const Picture& student, const Picture& expected,
                                             const std::vector<std::uint8_t>& smooth);

}
