#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>

namespace umbral::pipeline {

/// A rectangle of the plane with its borders, y up: low.x <= x <= high.x, low.y <= y <= high.y. All four numbers
/// are finite; `low` is not beyond `high`, and may equal it.
struct ClipWindow {
    glm::vec2 low;
    glm::vec2 high;
};

struct LineSegment {
    glm::vec2 from;
    glm::vec2 to;
};

/// In which of nine regions a point lies, as bits: 1 left of the window (x < low.x), 2 right of it, 4 below it, 8 above
/// it. On a border: not beyond it.
[[nodiscard]] unsigned region_code(const ClipWindow& window, const glm::vec2& point);

/// The part of a segment inside the window, in the same direction; nothing if they share no point.
///
/// An end inside stays as it is; a new end lies exactly on a border, and in the window. A segment that touches the
/// window in one point gives that point twice; a point (from = to) is in it or not. Nothing comes of a segment with
/// a number that is NaN or infinite. Guarantee of the reference: the reversed segment gives the same ends, bit by bit.
/// For coordinates up to 2^20 times the window's, new ends are within one ulp of its largest coordinate, and hit or
/// miss is right if the line passes every corner by 2^-24 of one ulp or more. Course: Cohen-Sutherland.
[[nodiscard]] std::optional<LineSegment> clip_segment(const ClipWindow& window, const LineSegment& segment);

}
