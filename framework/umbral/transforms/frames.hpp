#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::transforms {

/// A frame of reference: three vectors and an origin, all in coordinates of the world, whose own frame is Cartesian.
/// They may have any lengths and angles.
struct Frame {
    glm::vec3 x;
    glm::vec3 y;
    glm::vec3 z;
    glm::vec3 origin;
};

/// What a frame is, from the weakest to the strongest; each of the last three is also what stands before it.
enum class FrameKind : std::int32_t {
    degenerate = 0,   ///< its vectors lie in a plane: it cannot give coordinates to all points
    oblique = 1,      ///< it can, and no more
    orthogonal = 2,   ///< its vectors are perpendicular to each other
    orthonormal = 3,  ///< and of length 1
    cartesian = 4     ///< and right-handed
};

/// The matrix from coordinates in the frame to those in the world: the course's M_{W,F}, whose columns are the frame.
[[nodiscard]] glm::mat4 frame_matrix(const Frame& frame);

/// The matrix from coordinates in the world to those in the frame, which may be any that is not degenerate. The
/// reference rounds once where the volume of the frame's vectors is at least 1e-6 of the product of their lengths: it
/// computes in double, which keeps no more of a thinner frame, nor of terms that cancel each other to 1e-9 of their
/// size. The same holds of `to` in between_frames.
[[nodiscard]] glm::mat4 inverse_of_frame(const Frame& frame);

/// The same for a Cartesian frame, by the transpose: no division, no determinant. What it makes of other frames is not
/// asked.
[[nodiscard]] glm::mat4 inverse_of_cartesian(const Frame& frame);

/// The matrix from coordinates in `from` to coordinates in `to`. The reference rounds once, so that two frames that are
/// far away from the world's origin and near each other are seen as near each other.
[[nodiscard]] glm::mat4 between_frames(const Frame& from, const Frame& to);

/// 1 for a right-handed frame, -1 for a left-handed one, 0 for a degenerate one: the sign of the determinant of its
/// vectors. Exact for all finite floats.
[[nodiscard]] int orientation(const Frame& frame);

/// What the frame is. Two vectors count as perpendicular if the cosine of their angle is at most 1e-4, and as unit if
/// their length is within 1e-4 of 1.
[[nodiscard]] FrameKind classify_frame(const Frame& frame);

}
