#include <umbral/transforms/frames.hpp>

namespace umbral::transforms {

glm::mat4 frame_matrix(const Frame& frame)
{
    // TODO: the columns are the frame: three vectors (w = 0) and a point (w = 1).
    return not_implemented<glm::mat4>(frame);
}

glm::mat4 inverse_of_frame(const Frame& frame)
{
    // TODO: the general inverse.
    return not_implemented<glm::mat4>(frame);
}

glm::mat4 inverse_of_cartesian(const Frame& frame)
{
    // TODO: first Tra[-origin], then the transpose: without any division.
    return not_implemented<glm::mat4>(frame);
}

glm::mat4 between_frames(const Frame& from, const Frame& to)
{
    // TODO: from `from` to the world, from the world to `to`. For the hard check: subtract the origins before anything
    // rounds.
    return not_implemented<glm::mat4>(from, to);
}

int orientation(const Frame& frame)
{
    // TODO: 1, -1 or 0, as the sign of the determinant of x, y and z.
    return not_implemented<int>(frame);
}

FrameKind classify_frame(const Frame& frame)
{
    // TODO: ask in the order of the enumeration: does it span space? Are its vectors perpendicular? Unit? Right-handed?
    return not_implemented<FrameKind>(frame);
}

}
