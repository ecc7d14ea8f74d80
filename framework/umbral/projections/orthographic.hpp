#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/projections/view_volume.hpp>

namespace umbral::projections {

/// The matrix that takes a box of camera coordinates to the cube [-1, 1]³ of OpenGL: `left` to x = -1 and `right` to 1,
/// `bottom` to y = -1 and `top` to 1, the plane z = -near_plane to -1 and z = -far_plane to 1.
///
/// Column vectors, column-major storage; the last row is 0 0 0 1, so w stays 1. Sides may lie anywhere: left > right
/// mirrors the picture, near_plane > far_plane exchanges front and back, negative planes lie behind the camera. Throws
/// std::invalid_argument if two opposite sides are equal. Guarantee of the reference: every entry is the exact one
/// rounded to float once, but for a part in 10^14, as long as it is a float at all, also where the sum or the
/// difference of two sides is none. Course: MAT_Ortografica, glOrtho.
[[nodiscard]] glm::mat4 orthographic_matrix(const ViewVolume& box);

/// Its inverse: takes the cube back to the box. What is said above holds here too.
[[nodiscard]] glm::mat4 inverse_orthographic_matrix(const ViewVolume& box);

}
