#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <vector>

/// Projections that bend straight lines. Points are in camera coordinates: the eye at the origin, looking along -z.
namespace umbral::projections {

/// Where a point appears, and its distance from the eye, by which hidden surfaces are found: not its depth -z.
struct CurvedPoint {
    glm::vec2 place;
    float distance;
};

/// The half of the world before the eye in a disc of radius 1, as in a mirror ball or a fisheye lens: the point is
/// moved along its ray to the unit sphere round the eye, and its x and y are the place.
///
/// Nothing for points behind the plane of the eye (z > 0), which would appear in the places of others, and for the eye
/// itself. Guarantee of the reference, here and below: every number is the exact one rounded to float once, but for a
/// part in 10^12, for coordinates of any size from 1e-35 to 1e37. Course: proyección esférica, x' = x/d, z' = d.
[[nodiscard]] std::optional<CurvedPoint> spherical_projection(const glm::vec3& point);

/// All round the eye on a cylinder of radius 1 about the y axis, rolled out. x of the place is the angle about that
/// axis in radians: 0 straight ahead, positive to the right, more than -π and at most π, so π straight behind whatever
/// the sign of a zero. y is where the ray meets the cylinder, the tangent of its elevation.
///
/// Nothing for points of the y axis, whose rays do not meet it. Course: proyección cilíndrica.
[[nodiscard]] std::optional<CurvedPoint> cylindrical_projection(const glm::vec3& point);

/// The angle in radians under which the eye sees the edge from a to b: 0 to π. 0 if a or b is the eye.
[[nodiscard]] float visual_angle(const glm::vec3& a, const glm::vec3& b);

/// Triangles (three corners each) cut so finely that their edges may be drawn straight: each into four at the middles
/// of its edges, all of them equally often, so that neighbours still fit; as often as is needed until the eye sees no
/// edge under more than `largest_angle`, but at most 6 times.
///
/// Triangles keep their sense, and may come in any order, begun at any corner. A middle is half the sum of two corners,
/// rounded to float. Throws std::invalid_argument if the number of corners is no multiple of 3, or if largest_angle is
/// not more than 0.
[[nodiscard]] std::vector<glm::vec3> tessellated(std::span<const glm::vec3> corners, float largest_angle);

/// The angles of a triangle's three corners on the cylinder, in radians, for drawing it in one piece across the seam
/// at ±π: the first as it is, the others moved by a whole turn (2π) where they are more than π away from the first.
///
/// They come from cylindrical_projection, and go from -2π to 2π.
[[nodiscard]] std::array<float, 3> without_seam(const std::array<float, 3>& angles);

}
