#pragma once

#include <glm/glm.hpp>
#include <span>
#include <umbral/core/not_implemented.hpp>

namespace umbral::transforms {

// The usual matrices of the course, for column vectors: the point p becomes M · p, and the last row is 0 0 0 1.
// Coordinates are numbered 0, 1, 2 for x, y, z. Angles are in radians; a rotation is counter-clockwise for whoever
// looks from the tip of its axis at the origin.

/// Tra[d]: moves points by `offset`, and leaves free vectors alone. Course: MAT_Traslacion.
[[nodiscard]] glm::mat4 translation_matrix(const glm::vec3& offset);

/// Esc[s]: multiplies each coordinate by its factor, which may be negative (a mirror) or 0. Course: MAT_Escalado.
[[nodiscard]] glm::mat4 scaling_matrix(const glm::vec3& factors);

/// Ciz: adds `amount` times the coordinate `by` to the coordinate `moved`; the two are different. shear_matrix(0, 1, a)
/// is Ciz_xy[a].
[[nodiscard]] glm::mat4 shear_matrix(int moved, int by, float amount);

/// Rot_x, Rot_y, Rot_z: the elementary rotations.
[[nodiscard]] glm::mat4 rotation_about_x(float angle);
[[nodiscard]] glm::mat4 rotation_about_y(float angle);
[[nodiscard]] glm::mat4 rotation_about_z(float angle);

/// What the matrix makes of a point (w = 1) and of a free vector (w = 0). Each product in the sums fits into a float:
/// none is beyond 1e36.
[[nodiscard]] glm::vec3 transform_point(const glm::mat4& matrix, const glm::vec3& point);
[[nodiscard]] glm::vec3 transform_vector(const glm::mat4& matrix, const glm::vec3& vector);

/// The matrix that does all these steps, the first one first: M_n · … · M_2 · M_1; the identity for none.
/// Course: "composición de transformaciones".
[[nodiscard]] glm::mat4 compose_matrices(std::span<const glm::mat4> steps);

}
