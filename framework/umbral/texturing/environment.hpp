#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::texturing {

/// The six faces of a box round the observer, by the axis on which they stand.
enum class BoxFace { right, left, top, bottom, back, front };  // +x, -x, +y, -y, +z, -z

/// A place of a box map: a face, and coordinates in [0, 1] x [0, 1] on it.
struct BoxPlace {
    BoxFace face = BoxFace::right;
    glm::vec2 uv{0};
};

/// The direction in which one sees the environment in a mirror: `to_eye`, of any length, turned by half a turn about
/// the unit normal, 2 (n · v) n - v. It has the length of `to_eye`. Also where the eye is behind the surface.
/// Guarantee of the reference: within 4 ulp of its length. Course: slide F33 (which looks along -r).
[[nodiscard]] glm::vec3 mirrored_direction(const glm::vec3& to_eye, const glm::vec3& normal);

/// Where a direction, of any length but 0, leaves the box [-1, 1]^3 from its centre. The face is that of the coordinate
/// of largest absolute value; of equal ones the first of x, y, z. With that absolute value m, u = 1/2 + a/(2m) and
/// v = 1/2 + b/(2m), where
///
///     face   right  left  top  bottom  back  front
///     a        z     -z    x     x      -x     x        (to the right, as seen from inside)
///     b        y      y    z    -z       y     y        (upwards)
///
/// Top and bottom are as one sees them who looks to the front, -z, and then raises or lowers the head. For directions
/// of any length that a float can have, subnormal ones too. Of two absolute values that differ, but by less than a part
/// in 2^19, rounding may choose; of equal ones it may not. Guarantee of the reference, here and below where no other is
/// given: within 1.2e-7. Course: slide F34.
[[nodiscard]] BoxPlace box_place(const glm::vec3& direction);

/// The direction that box_place takes there, on the box: its largest coordinate is 1 or -1.
[[nodiscard]] glm::vec3 box_direction(const BoxPlace& place);

/// Where an equirectangular panorama shows a direction of any length but 0: u = 1/2 + α/(2π) with the longitude
/// α = atan2(x, -z), which is 0 in front (-z) and grows to the right, and v = 1/2 + β/π with the latitude
/// β = atan2(y, √(x² + z²)). Exactly behind (x = 0, z > 0) u is 1, whichever sign the zero has; straight up and down it
/// is 1/2. Course: slide F37.
[[nodiscard]] glm::vec2 panorama_place(const glm::vec3& direction);

/// The unit direction of a place of the panorama, for v in [0, 1]. u repeats; it may lie a few turns
/// outside [0, 1].
[[nodiscard]] glm::vec3 panorama_direction(glm::vec2 uv);

/// Where a spherical map shows a mirrored direction of any length but 0. The map is the picture of a mirroring ball
/// seen from far away along -z: at (u, v) the ball has the normal n with n_x = 2u - 1, n_y = 2v - 1, and mirrors r = 2
/// n_z n - z. So n is the direction half way between r and +z. For r = -z, which the whole rim of the ball shows, the
/// place is (1, 1/2). Guarantee of the reference: within 2.4e-7, also beside -z. Course: slide F36.
[[nodiscard]] glm::vec2 sphere_place(const glm::vec3& direction);

/// The unit direction that the spherical map shows at (u, v); outside the ball's disc, that of its rim, -z.
/// Guarantee of the reference: within 1.2e-6. With panorama_place it makes a spherical map from a panorama.
[[nodiscard]] glm::vec3 sphere_direction(glm::vec2 uv);

}
