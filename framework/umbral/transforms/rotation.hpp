#pragma once

#include <glm/glm.hpp>
#include <span>
#include <umbral/core/not_implemented.hpp>

namespace umbral::transforms {

/// A turn by `angle` radians about the line through the origin along `axis`.
///
/// Counter-clockwise seen from the tip of the axis, looking at the origin (right-hand rule). Only the direction of the
/// axis counts: it may have any length. A turn turns nothing if its axis is zero, or if any of its numbers is not
/// finite.
struct AxisAngle {
    glm::vec3 axis;
    float angle;
};

/// The vector that `vector` becomes in this turn (Rodrigues' formula).
/// Course: "fórmula de Rodrigues".
[[nodiscard]] glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn);

/// The matrix of this turn: M · (v, 1) = (rotate_vector(v), 1) for every v; the identity if it turns nothing.
/// Course: MAT_Rotacion, but in radians.
[[nodiscard]] glm::mat4 rotation_matrix(const AxisAngle& turn);

/// The matrix of many turns, the first one first, all about axes of the world: M = M_n · … · M_2 · M_1; the identity
/// for none.
///
/// Made for chains of millions of small turns: no length, angle or direction drifts.
/// Course: "composición de transformaciones"; the drift of products of matrices.
[[nodiscard]] glm::mat4 compose_rotations(std::span<const AxisAngle> turns);

}
