#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::pipeline {

/// The part of a polygon inside a convex window, as the corners of one polygon that turns as the given one does.
///
/// `polygon` may be concave and turn either way; its sides cross each other nowhere, but may touch. `window` has three
/// corners or more, counter-clockwise (y up). The window is cut to in the order of its sides, from window[0] to
/// window[1] first, the one back to window[0] last. It has its borders: a corner on a side stays. What is left of a
/// concave polygon may be several pieces: they come as one polygon, joined by bridges along the window's sides that are
/// run through twice, there and back, and enclose nothing. No corner comes twice in a row, and where it does it counts
/// once. Nothing comes of fewer than three corners, before or after, nor of NaN or infinity. Guarantee of the
/// reference: corners are within one ulp of the largest coordinate, of the polygon or the window, as long as these are
/// not more than 2^20 times as large as what is left. Course: Sutherland-Hodgman (its "problems with convex polygons"
/// are those with concave ones).
[[nodiscard]] std::vector<glm::vec2> clip_polygon(const std::vector<glm::vec2>& polygon,
                                                  const std::vector<glm::vec2>& window);

}
