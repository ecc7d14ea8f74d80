// mistake: every formula in float, one frame to the other by way of the world
// credit: 68..82
// hint: Frames that are far from the world's origin lose their place when they go through the world in float: subtract
// the origins first, and compute in double.
#include <umbral/transforms/frames.hpp>

namespace umbral::transforms {

glm::mat4 frame_matrix(const Frame& frame)
{
    return {glm::vec4(frame.x, 0), glm::vec4(frame.y, 0), glm::vec4(frame.z, 0), glm::vec4(frame.origin, 1)};
}

glm::mat4 inverse_of_frame(const Frame& frame) { return glm::inverse(frame_matrix(frame)); }

glm::mat4 inverse_of_cartesian(const Frame& frame)
{
    const glm::mat3 back = glm::transpose(glm::mat3(frame.x, frame.y, frame.z));
    glm::mat4 m(back);
    m[3] = glm::vec4(-(back * frame.origin), 1);
    return m;
}

glm::mat4 between_frames(const Frame& from, const Frame& to) { return inverse_of_frame(to) * frame_matrix(from); }

int orientation(const Frame& frame)
{
    const float volume = glm::determinant(glm::mat3(frame.x, frame.y, frame.z));
    return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

FrameKind classify_frame(const Frame& frame)
{
    const auto perpendicular = [](const glm::vec3& a, const glm::vec3& b) {
        return std::abs(dot(a, b)) <= 1e-4F * length(a) * length(b);
    };
    const auto unit = [](const glm::vec3& v) { return std::abs(length(v) - 1) <= 1e-4F; };
    const auto& [x, y, z, origin] = frame;
    const int side = orientation(frame);
    if (side == 0) return FrameKind::degenerate;
    if (!perpendicular(x, y) || !perpendicular(y, z) || !perpendicular(z, x)) return FrameKind::oblique;
    if (!unit(x) || !unit(y) || !unit(z)) return FrameKind::orthogonal;
    return side > 0 ? FrameKind::cartesian : FrameKind::orthonormal;
}

}
