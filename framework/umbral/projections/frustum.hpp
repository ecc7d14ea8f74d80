#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/projections/view_volume.hpp>

namespace umbral::projections {

/// The perspective matrix of a frustum, to OpenGL's clip coordinates: after division by w, which is -z, its side planes
/// lie at x = -1 (left), x = 1 (right), y = -1 (bottom) and y = 1 (top), z = -near_plane at -1 and z = -far_plane at 1.
///
/// Column vectors, column-major storage. The frustum need not be symmetric; left > right mirrors the picture, bottom >
/// top turns it over, near_plane > far_plane exchanges front and back. `far_plane` may be infinite: the entries are
/// then their limits. Throws std::invalid_argument if two opposite sides are equal, or if a plane is not at a positive
/// distance. Guarantee of the reference: every entry is the exact one rounded to float once, but for a part in 10^8, as
/// long as it is a float at all. Course: MAT_Frustum, glFrustum, matrix Q.
[[nodiscard]] glm::mat4 frustum_matrix(const ViewVolume& volume);

/// The same matrix in three steps, of which the right one acts first: normalization * scaling * shear.
struct FrustumFactors {
    glm::mat4 shear;          ///< H: moves the middle of the near window to the -z axis, and leaves z alone
    glm::mat4 scaling;        ///< S: scales x and y only, until the side planes are x = ±z and y = ±z
    glm::mat4 normalization;  ///< N: leaves x and y alone, makes z from z and w, and w = -z
};

/// The three factors; what is said of `frustum_matrix` holds here too. Course: P = N S H.
[[nodiscard]] FrustumFactors frustum_factors(const ViewVolume& volume);

/// Where a projection shows a point: in normalised device coordinates, whether inside the cube or not. Nothing if the
/// point's w is 0 or negative, as it is for points in the plane of the eye and behind it.
///
/// Guarantee of the reference: within 1e-15 times the sum of the terms' sizes over w, and one rounding to float.
[[nodiscard]] std::optional<glm::vec3> project_point(const glm::mat4& projection, const glm::vec3& point);

}
