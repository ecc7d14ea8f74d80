#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/projections/view_volume.hpp>

namespace umbral::projections {

/// How a parallel projection leans: what lies one unit farther from the viewer appears moved by `foreshortening` units
/// in the picture, in the direction `angle_degrees` (0: to the right, 90: upwards).
struct Lean {
    float angle_degrees;
    float foreshortening;  ///< 1: cavalier, 1/2: cabinet, 0: orthogonal; negative: the opposite direction
};

/// The foreshortening that belongs to an angle between the projecting rays and the view plane: more than 0 and at most
/// 90 degrees. 45° give 1 (cavalier), 63.4349° give 1/2 (cabinet), 90° give 0 (orthogonal).
///
/// Throws std::invalid_argument for other angles, NaN too. Guarantee of the reference: the exact number rounded to
/// float once, but for a part in 10^12; 90° give exactly 0. Course: tan α = 1 and tan α = 2.
[[nodiscard]] float foreshortening_of(float alpha_degrees);

/// The shear that makes an orthogonal projection along z of an oblique one: points of the plane z = 0 stay where they
/// are, and z stays as it is. The camera looks along -z, so what lies farther has the smaller z.
///
/// Column vectors, column-major storage. Guarantee of the reference, here and below: each entry or component is the
/// exact one within one rounding and 1e-15 of its column's or vector's size. Course: oblique parallel projection.
[[nodiscard]] glm::mat4 oblique_shear(const Lean& lean);

/// The matrix that shows a box obliquely in OpenGL's cube [-1, 1]³: sheared first, then projected orthographically, so
/// that `left` … `top` bound the picture in the plane z = 0. Depths are those of the box. Opposite sides differ.
[[nodiscard]] glm::mat4 oblique_matrix(const ViewVolume& box, const Lean& lean);

/// The unit vector along which the viewer looks: all points of a line in this direction appear in one place, the first
/// ones before the others.
[[nodiscard]] glm::vec3 projector_direction(const Lean& lean);

}
