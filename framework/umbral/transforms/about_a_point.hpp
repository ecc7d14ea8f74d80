#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {

// Transformations that leave something other than the origin in its place. Directions and normals may have any length;
// one that is null changes nothing, and the matrix is the identity. The reference computes in double and rounds each
// entry once.

/// A turn about the line through `centre` along the axis; the identity if it turns nothing (see AxisAngle). Course:
/// Rot[θ, p].
[[nodiscard]] glm::mat4 rotation_about_point(const glm::vec3& centre, const AxisAngle& turn);

/// Multiplies the distances from `centre` along x, y and z by these factors.
[[nodiscard]] glm::mat4 scaling_about_point(const glm::vec3& centre, const glm::vec3& factors);

/// A scaling along any axis: multiplies the distances from the plane through `point` across `direction` by `factor`,
/// and leaves the plane in its place. -1 is the mirror, 0 presses everything onto the plane. Course: "escalado" along
/// an axis that is none of the world's.
[[nodiscard]] glm::mat4 scaling_along(const glm::vec3& point, const glm::vec3& direction, float factor);

/// The symmetry about a point: `centre` is the middle between each point and its image.
[[nodiscard]] glm::mat4 reflection_in_point(const glm::vec3& centre);

/// The symmetry about the line through `point` along `direction`: half a turn.
[[nodiscard]] glm::mat4 reflection_in_line(const glm::vec3& point, const glm::vec3& direction);

/// The mirror: the symmetry about the plane through `point` across `normal`.
[[nodiscard]] glm::mat4 reflection_in_plane(const glm::vec3& point, const glm::vec3& normal);

/// The shortest rotation about the origin that takes the direction of `from` to that of `to`: it leaves what is
/// perpendicular to both in its place.
///
/// If they are exactly opposite there are many; it is half a turn about from × e then, where e is the axis of the world
/// in which `from` has its smallest component by size (the first of equals). The identity if either is null. Good to a
/// rounding where they are 1e-6 or more from opposite. Course: "alineación de vectores".
[[nodiscard]] glm::mat4 alignment(const glm::vec3& from, const glm::vec3& to);

/// Places an object at `position` with its z along `direction` and its y as near to the world's y as can be:
/// x = unit(Y × direction), y = z × x, z = unit(direction) are the first three columns.
///
/// If `direction` is exactly along the world's y axis, x is (1, 0, 0). If it is null, the object is moved and not
/// turned. Course: "alinear un objeto".
[[nodiscard]] glm::mat4 placed_along(const glm::vec3& position, const glm::vec3& direction);

}
