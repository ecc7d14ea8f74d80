#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::projections {

/// The matrix V that takes world coordinates to camera coordinates: right-handed, the camera at the origin looking
/// along -z.
///
/// `eye` is where the camera stands, `target` the point it looks at, `up` any vector (not necessarily unit, nor
/// perpendicular to the view) that shall appear vertical and pointing up. Column vectors, column-major storage: V *
/// vec4(eye, 1) = (0, 0, 0, 1). Degenerate input never gives NaN: if `up` is parallel to the view (the sine of the
/// angle between them is below 1e-6) or is zero, the world axis that is most perpendicular to the view takes its place
/// (of equals, the first of x, y, z); if eye and target are equal, the camera looks along the world's -z. Guarantee of
/// the reference, for eyes up to 1e6 from the origin: every entry is the exact one rounded to float once, but for 2e-10
/// of the largest of its column. So the rotation is within 3.1e-8 in every entry and the translation within one
/// rounding of the size of `eye`, also where `up` is almost parallel to the view (sine down to 2e-6). Course:
/// problems 3.3 and 3.4, MAT_LookAt.
[[nodiscard]] glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up);

}
