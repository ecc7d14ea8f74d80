#include <cmath>
#include <umbral/pipeline/clip_line.hpp>

#include "wide.hpp"

// Parameters instead of region codes (Liang and Barsky), with 113 bits: coordinates up to a million times the window's
// are exact, and so are all comparisons, which need no division. New ends are rounded to float once.

namespace umbral::pipeline {
namespace {

// A parameter on the segment as a fraction with a positive denominator, and the border that it belongs to.
struct Place {
    Wide numerator, denominator;
    int axis;  // -1: an end of the segment
    float border;
};

bool before(const Place& a, const Place& b) { return a.numerator * b.denominator < b.numerator * a.denominator; }

glm::vec2 point_at(const LineSegment& segment, const Place& place)
{
    if (place.axis < 0) return place.numerator == 0 ? segment.from : segment.to;
    const int other = 1 - place.axis;
    const Wide start = segment.from[other];
    glm::vec2 point;
    point[place.axis] = place.border;
    point[other] = static_cast<float>(
        (start * place.denominator + place.numerator * (Wide(segment.to[other]) - start)) / place.denominator);
    return point;
}

}

unsigned region_code(const ClipWindow& window, const glm::vec2& point)
{
    const unsigned across = point.x < window.low.x ? 1 : point.x > window.high.x ? 2 : 0;
    return across | (point.y < window.low.y ? 4U : point.y > window.high.y ? 8U : 0U);
}

std::optional<LineSegment> clip_segment(const ClipWindow& window, const LineSegment& segment)
{
    Place first{0, 1, -1, 0};
    Place last{1, 1, -1, 0};
    for (int axis = 0; axis < 2; ++axis) {
        if (!std::isfinite(segment.from[axis]) || !std::isfinite(segment.to[axis])) return std::nullopt;
        const Wide start = segment.from[axis];
        const Wide step = Wide(segment.to[axis]) - start;
        for (const float border : {window.low[axis], window.high[axis]}) {
            const bool is_low = border == window.low[axis];
            if (step == 0) {
                if (start < Wide(window.low[axis]) || start > Wide(window.high[axis])) return std::nullopt;
                continue;
            }
            const Wide sign = step > 0 ? 1 : -1;
            const Place place{sign * (Wide(border) - start), sign * step, axis, border};
            const bool entering = is_low == (step > 0);
            if (entering && before(first, place)) first = place;
            if (!entering && before(place, last)) last = place;
            if (window.low[axis] == window.high[axis]) {  // both borders at once
                if (before(first, place)) first = place;
                if (before(place, last)) last = place;
            }
        }
    }
    if (before(last, first)) return std::nullopt;
    return LineSegment{point_at(segment, first), point_at(segment, last)};
}

}
