#pragma once

#include <array>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::texturing {

/// A plane to project on: its origin has the coordinates (0, 0), and the two axes, unit and perpendicular to each
/// other, are the directions in which u and v grow by 1 for each unit of length.
struct TexturePlane {
    glm::vec3 origin{0};
    glm::vec3 u_axis{1, 0, 0};
    glm::vec3 v_axis{0, 1, 0};
};

/// The coordinates (u, v) of a point that is projected perpendicularly on the plane: u = (point - origin) · u_axis, v
/// likewise. Not wrapped or clamped. The reference is right to 4 ulp of the larger of the coordinate and the distance
/// of point and origin. Course: row C 1.8, "proyección en un plano".
[[nodiscard]] glm::vec2 planar_coordinates(const glm::vec3& point, const TexturePlane& plane);

/// The coordinates of a point by its direction from the origin; its distance does not matter.
///
/// u = 1/2 + α/(2π) with the longitude α = atan2(z, x) in (-π, π], and v = 1/2 + β/π with the latitude
/// β = atan2(y, √(x² + z²)): the south pole -y has v = 0, the north pole v = 1. **-0 is 0**: on the seam (z = 0, x < 0)
/// u is 1, and on the axis (x = z = 0), which has no longitude, u is 1/2. The origin has (1/2, 1/2). The reference is
/// right to 1.2e-7 for all finite points, also where squares of floats overflow or vanish. Course: row C 1.8,
/// "coordenadas esféricas".
[[nodiscard]] glm::vec2 spherical_coordinates(const glm::vec3& point);

/// The coordinates of a point by longitude and height: u as in spherical_coordinates, v = (y - y_min) / (y_max -
/// y_min), which is not clamped. A cylinder without height (y_min = y_max) has v = 0. Right to 1.2e-7, and v to 4 ulp
/// where it is larger; y_max - y_min may overflow a float. Course: row C 1.8, "coordenadas cilíndricas".
[[nodiscard]] glm::vec2 cylindrical_coordinates(const glm::vec3& point, float y_min, float y_max);

/// The coordinates (s, t) of the vertices of a parametric surface, a grid of `columns` x `rows` cells: (i/columns,
/// j/rows) for i = 0 … columns and j = 0 … rows, row by row from t = 0, s growing within a row. So the first column and
/// the last one, which a closed surface has in the same place, differ in s, and there is no smear between them. Right
/// to 1e-7. Throws std::invalid_argument if columns or rows is less than 1. Course: row C 1.8, "coordenadas
/// paramétricas".
[[nodiscard]] std::vector<glm::vec2> parametric_coordinates(int columns, int rows);

/// Spherical coordinates for the three corners of one triangle, such that they can be interpolated in it without a
/// smear. v is that of spherical_coordinates. u is too, with two exceptions:
///
/// - If the u of two corners differ by more than 1/2, the triangle crosses the seam: those below 1/2 get 1 more. The
///   texture is repeated there.
/// - A corner on the axis (x = z = 0) has no longitude of its own, and counts for nothing in the rule above. It gets
///   the mean of the final u of the other corners, or that of the only other one. If all three lie there, they keep
///   1/2.
///
/// For triangles that span less than half a turn, which is all without the axis inside. Right to 2.4e-7. Course:
/// "problemas en la costura y en los polos".
[[nodiscard]] std::array<glm::vec2, 3> spherical_triangle(const std::array<glm::vec3, 3>& corners);

}
