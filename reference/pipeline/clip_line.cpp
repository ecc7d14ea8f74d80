// Based on: D. Cohen, I. Sutherland, in: W. Newman, R. Sproull. Principles of Interactive Computer Graphics. 2nd
// edition, 1979.

#include <umbral/pipeline/clip_line.hpp>

namespace umbral::pipeline {
namespace {

enum Region : unsigned { left = 1, right = 2, below = 4, above = 8 };

unsigned code_of(const ClipWindow& window, const glm::dvec2& point)
{
    unsigned code = 0;
    if (point.x < double{window.low.x}) code |= left;
    if (point.x > double{window.high.x}) code |= right;
    if (point.y < double{window.low.y}) code |= below;
    if (point.y > double{window.high.y}) code |= above;
    return code;
}

// Where the line through two points has this coordinate on this axis. Whole, it is the same for both directions, and
// nothing is subtracted from a far end: products of floats are exact in double.
glm::dvec2 crossing(const glm::dvec2& a, const glm::dvec2& b, int axis, double border)
{
    const int other = 1 - axis;
    glm::dvec2 point;
    point[axis] = border;
    point[other] = (a[other] * (b[axis] - border) + b[other] * (border - a[axis])) / (b[axis] - a[axis]);
    return point;
}

// The point where the line enters the first half-plane, of those in the code, that the outer end is not in.
glm::dvec2 cut(const ClipWindow& window, const glm::dvec2& a, const glm::dvec2& b, unsigned code)
{
    if ((code & (left | right)) != 0)
        return crossing(a, b, 0, double{(code & left) != 0 ? window.low.x : window.high.x});
    return crossing(a, b, 1, double{(code & below) != 0 ? window.low.y : window.high.y});
}

bool finite(const glm::vec2& point) { return glm::all(glm::equal(0.0F * point, glm::vec2(0))); }

}

unsigned region_code(const ClipWindow& window, const glm::vec2& point) { return code_of(window, point); }

std::optional<LineSegment> clip_segment(const ClipWindow& window, const LineSegment& segment)
{
    if (!finite(segment.from) || !finite(segment.to)) return std::nullopt;
    const glm::dvec2 a(segment.from);
    const glm::dvec2 b(segment.to);
    glm::dvec2 from = a;
    glm::dvec2 to = b;
    unsigned from_code = code_of(window, from);
    unsigned to_code = code_of(window, to);

    // Each end is cut twice at most. Every cut begins with the whole segment, so that errors of one do not enter the
    // next.
    for (int cuts = 0; cuts <= 4; ++cuts) {
        if ((from_code & to_code) != 0) return std::nullopt;
        if (from_code != 0)
            from_code = code_of(window, from = cut(window, a, b, from_code));
        else if (to_code != 0)
            to_code = code_of(window, to = cut(window, a, b, to_code));
        else
            return LineSegment{glm::vec2(from), glm::vec2(to)};
    }
    return std::nullopt;
}

}
