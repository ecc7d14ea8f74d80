#pragma once

#include <array>
#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/texturing/lookup.hpp>

namespace umbral::texturing {

/// How a point of a surface moves with its texture coordinates: the derivatives of the position by u (tangent) and by v
/// (bitangent). Neither unit nor perpendicular in general.
struct Tangents {
    glm::vec3 u{0};
    glm::vec3 v{0};
};

/// The slopes (d_u, d_v) of a height field at (u, v), by central differences: d_u = k (h(u + D, v) - h(u - D, v)) /
/// (2D), where D = 1/columns; d_v likewise, where D = 1/rows. The height h is the red of a bilinear lookup in the
/// texture, which is repeated; k exaggerates the relief, or flattens it, and may be negative. The texture has at least
/// one texel. Right to 2e-7 k n² h for u and v up to 2, with n columns or rows and heights up to h. Course: slides F7
/// to F9.
[[nodiscard]] glm::vec2 slopes(const Grid<glm::vec4>& heights, glm::vec2 uv, float k);

/// The tangents of a triangle whose corners have these positions and texture coordinates: position = corner 0 + t_u
/// (u - u0) + t_v (v - v0) in all of it. Both are 0 if the coordinates of the corners lie on a line, where there are no
/// tangents; not so in a triangle that is merely small, as those of fine meshes are. Right to 1e-6 of the larger
/// tangent's length if the angles of the triangle in the texture are not tiny. Course: slides F10 to F12.
[[nodiscard]] Tangents triangle_tangents(const std::array<glm::vec3, 3>& positions,
                                         const std::array<glm::vec2, 3>& coordinates);

/// The unit normal of a surface whose points are raised along its unit normal n by heights of these slopes: that of the
/// tangents t_u + d_u n and t_v + d_v n, **on the side of n**. (Where the texture is mirrored, t_u x t_v points against
/// n.) n need not be perpendicular to the tangents: the normals of meshes are interpolated. The result is NaN where
/// rounding leaves nothing of it: slopes far beyond the bound below can. It is n itself if (t_u x t_v) · n is 0: if
/// there are no tangents, or their plane holds n. Right to 4e-7 for tangents of any length, at any angle that is not
/// tiny, and slopes of up to 10^6 times their length. Course: slide F13.
[[nodiscard]] glm::vec3 bumped_normal(const glm::vec3& n, const Tangents& tangents, glm::vec2 slopes);

}
