#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::projections {

/// A camera that looks along the middle of what it sees, as photographers describe it.
struct Lens {
    float fovy_degrees;  ///< the angle between the lower and the upper side plane: more than 0, less than 180
    float aspect;        ///< width over height of the picture, more than 0
    float near_plane;    ///< distance of the near plane, more than 0
    float far_plane;     ///< distance of the far plane, more than that of the near one; may be infinite
};

/// The perspective matrix of such a camera, to OpenGL's clip coordinates: depth -1 at the near plane, 1 at the far one,
/// w = -z.
///
/// Column vectors, column-major storage. Throws std::invalid_argument if a number is not in the range that `Lens` gives
/// for it, or is NaN. Guarantee of the reference: every entry is the exact one rounded to float once, but for a part in
/// 10^8, for every angle. Course: MAT_Perspectiva, gluPerspective.
[[nodiscard]] glm::mat4 perspective_matrix(const Lens& lens);

/// The same but for depth, which after division by w is 1 at the near plane and 0 at the far one, for a depth buffer of
/// floats and glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE).
///
/// Guarantee of the reference: as above. Source: N. Reed. Depth precision visualized. 2015.
[[nodiscard]] glm::mat4 reversed_perspective_matrix(const Lens& lens);

/// The vertical field of view, in degrees, of a picture that is `aspect` times as wide as it is high and has this
/// horizontal one.
///
/// `fovx_degrees` is more than 0 and less than 180, `aspect` more than 0; else it throws std::invalid_argument.
/// Guarantee of the reference: the exact angle rounded to float once, but for a part in 10^12.
[[nodiscard]] float vertical_field_of_view(float fovx_degrees, float aspect);

}
