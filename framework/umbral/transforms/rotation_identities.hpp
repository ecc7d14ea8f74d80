#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <umbral/core/not_implemented.hpp>

namespace umbral::transforms {

/// The axes of the world.
enum class WorldAxis : std::int32_t { x = 0, y = 1, z = 2 };

/// An elementary rotation, Rot_x, Rot_y or Rot_z, about an axis of the world: counter-clockwise for whoever looks from
/// the tip of the axis at the origin. In **degrees**, as in the course's MAT_Rotacion: any finite number, any number of
/// times round, to either side.
///
/// A turn by a multiple of 90 degrees is exact: it exchanges coordinates and changes signs, and rounds nothing, however
/// often it goes round.
struct ElementaryTurn {
    WorldAxis axis;
    float degrees;
};

/// The vector after the turn; within 1e-7 of its length.
/// Course: problems 2.12 (dot products stay), 2.13 (lengths stay) and 2.14 (cross products turn along).
[[nodiscard]] glm::vec3 elementary_rotation(const glm::vec3& vector, const ElementaryTurn& turn);

/// The matrix of the turn; each entry within 1e-7, however small the angle is.
[[nodiscard]] glm::mat3 elementary_matrix(const ElementaryTurn& turn);

/// The vector after many turns, the first one first; within 1e-7 of its length, also after a million.
[[nodiscard]] glm::vec3 after_turns(const glm::vec3& vector, std::span<const ElementaryTurn> turns);

}
