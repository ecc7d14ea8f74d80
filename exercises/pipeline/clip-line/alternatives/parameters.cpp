// alternative: Liang and Barsky's parameters, in double

#include <umbral/pipeline/clip_line.hpp>

namespace umbral::pipeline {

unsigned region_code(const ClipWindow& window, const glm::vec2& point)
{
    const glm::bvec2 under = glm::lessThan(point, window.low);
    const glm::bvec2 over = glm::greaterThan(point, window.high);
    return (under.x ? 1U : 0U) + (over.x ? 2U : 0U) + (under.y ? 4U : 0U) + (over.y ? 8U : 0U);
}

std::optional<LineSegment> clip_segment(const ClipWindow& window, const LineSegment& segment)
{
    // Begins at the smaller end, so that both directions compute the same.
    const bool turned = std::pair(segment.to.x, segment.to.y) < std::pair(segment.from.x, segment.from.y);
    const glm::vec2 a = turned ? segment.to : segment.from;
    const glm::vec2 b = turned ? segment.from : segment.to;
    struct Place {
        double t;
        int axis;  // of the border that it lies on; -1: an end of the segment
        float border;
    };
    Place first{0, -1, 0};
    Place last{1, -1, 0};
    for (int axis = 0; axis < 2; ++axis) {
        const double start = a[axis];
        const double step = double{b[axis]} - start;
        if (!std::isfinite(step)) return std::nullopt;
        const double low = window.low[axis];
        const double high = window.high[axis];
        if (step == 0 && (start < low || start > high)) return std::nullopt;
        if (step == 0) continue;
        const Place at_low{(low - start) / step, axis, window.low[axis]};
        const Place at_high{(high - start) / step, axis, window.high[axis]};
        const Place& enters = step > 0 ? at_low : at_high;
        const Place& leaves = step > 0 ? at_high : at_low;
        if (enters.t > first.t) first = enters;
        if (leaves.t < last.t) last = leaves;
    }
    if (first.t > last.t) return std::nullopt;
    const auto at = [&](const Place& place) {
        if (place.axis < 0) return place.t == 0 ? a : b;
        glm::vec2 point((1 - place.t) * glm::dvec2(a) + place.t * glm::dvec2(b));
        point[place.axis] = place.border;
        return glm::clamp(point, window.low, window.high);
    };
    return turned ? LineSegment{at(last), at(first)} : LineSegment{at(first), at(last)};
}

}
