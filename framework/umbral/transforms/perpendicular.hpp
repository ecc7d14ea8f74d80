#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::transforms {

// Right angles and rotations in the plane, counter-clockwise (to the left) for positive angles, in radians.

/// A Cartesian frame of the plane, or its mirror image: two perpendicular unit vectors of either hand and an origin, in
/// coordinates of the world.
struct PlaneFrame {
    glm::vec2 x;
    glm::vec2 y;
    glm::vec2 origin;
};

/// P(u): u turned by a right angle to the left; exact. Course: problem 2.7.
[[nodiscard]] glm::vec2 turn_left(const glm::vec2& u);

/// The inverse of P: u turned by a right angle to the right; exact. Course: problem 2.8.
[[nodiscard]] glm::vec2 turn_right(const glm::vec2& u);

/// P as somebody computes it in the frame: with the coordinates (a, b) of `u` in the frame, the vector whose
/// coordinates there are (-b, a). `u` and the result are in coordinates of the world. Course: problem 2.9.
[[nodiscard]] glm::vec2 turn_vector_in(const PlaneFrame& frame, const glm::vec2& u);

/// The same for a point: with its coordinates (a, b) in the frame, the point whose coordinates there are (-b, a).
[[nodiscard]] glm::vec2 turn_point_in(const PlaneFrame& frame, const glm::vec2& point);

/// R(u) = cosθ u + sinθ P(u). Course: problems 2.10 and 2.11.
[[nodiscard]] glm::vec2 rotate_in_plane(const glm::vec2& u, float angle);

/// The matrix of that rotation about the origin, for points (x, y, 1) and vectors (x, y, 0): its last row and column
/// are those of the identity.
[[nodiscard]] glm::mat3 plane_rotation_matrix(float angle);

/// P_e(u) = e × u in space: perpendicular to both. Its length is |e||u| times the sine of their angle; null if they are
/// parallel. Components are at most 1e18: the products of larger ones are no floats.
[[nodiscard]] glm::vec3 across(const glm::vec3& e, const glm::vec3& u);

/// The matrix of P_e: across_matrix(e) · u = across(e, u) for every u.
[[nodiscard]] glm::mat3 across_matrix(const glm::vec3& e);

}
