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
    double first = 0;
    double last = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double start = a[axis];
        const double step = double{b[axis]} - start;
        if (!std::isfinite(step)) return std::nullopt;
        const double low = window.low[axis];
        const double high = window.high[axis];
        if (step == 0 && (start < low || start > high)) return std::nullopt;
        if (step == 0) continue;
        const double at_low = (low - start) / step;
        const double at_high = (high - start) / step;
        first = std::max(first, std::min(at_low, at_high));
        last = std::min(last, std::max(at_low, at_high));
    }
    if (first > last) return std::nullopt;
    const auto at = [&](double t) {
        if (t == 0) return a;
        if (t == 1) return b;
        const glm::dvec2 point = (1 - t) * glm::dvec2(a) + t * glm::dvec2(b);
        return glm::clamp(glm::vec2(point), window.low, window.high);
    };
    return turned ? LineSegment{at(last), at(first)} : LineSegment{at(first), at(last)};
}

}
