#include <umbral/pipeline/clip_line.hpp>

namespace umbral::pipeline {

unsigned region_code(const ClipWindow& window, const glm::vec2& point)
{
    // TODO: one bit for each border that the point lies beyond.
    return not_implemented<unsigned>(window, point);
}

std::optional<LineSegment> clip_segment(const ClipWindow& window, const LineSegment& segment)
{
    // TODO: as long as the codes of the ends do not decide: move an end that is outside to a border that it lies
    // beyond, and take its code anew.
    return not_implemented<std::optional<LineSegment>>(window, segment);
}

}
