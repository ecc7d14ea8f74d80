// mistake: the textbook's loop, in float
// credit: 65..85
// hint: In float a far end swallows the digits of the window: from a million away the new end is off by a sixteenth.
// And each cut
//     adds its error to the next. Compute in double, from the ends that you were given.

#include <umbral/pipeline/clip_line.hpp>

namespace umbral::pipeline {

unsigned region_code(const ClipWindow& window, const glm::vec2& point)
{
    unsigned code = 0;
    if (point.x < window.low.x) code |= 1;
    if (point.x > window.high.x) code |= 2;
    if (point.y < window.low.y) code |= 4;
    if (point.y > window.high.y) code |= 8;
    return code;
}

std::optional<LineSegment> clip_segment(const ClipWindow& window, const LineSegment& segment)
{
    auto [a, b] = segment;
    if (glm::any(glm::isnan(a + b)) || glm::any(glm::isinf(a + b))) return std::nullopt;
    unsigned code_a = region_code(window, a);
    unsigned code_b = region_code(window, b);
    for (int step = 0; step < 8; ++step) {
        if ((code_a | code_b) == 0) return LineSegment{a, b};
        if ((code_a & code_b) != 0) return std::nullopt;
        const unsigned code = code_a != 0 ? code_a : code_b;
        glm::vec2 point;
        if ((code & 3) != 0) {
            point.x = (code & 1) != 0 ? window.low.x : window.high.x;
            point.y = a.y + (b.y - a.y) * (point.x - a.x) / (b.x - a.x);
        } else {
            point.y = (code & 4) != 0 ? window.low.y : window.high.y;
            point.x = a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y);
        }
        if (code == code_a)
            code_a = region_code(window, a = point);
        else
            code_b = region_code(window, b = point);
    }
    return std::nullopt;
}

}
