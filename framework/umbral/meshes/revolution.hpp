#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <stdexcept>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

namespace umbral::meshes {

/// A mesh with a normal and texture coordinates for each vertex.
struct TexturedMesh {
    IndexedMesh mesh;
    std::vector<glm::vec3> normals;              ///< unit, or zero where there is none
    std::vector<glm::vec2> texture_coordinates;  ///< (s, t), in [0, 1]
};

/// The surface that a profile sweeps when it is turned about the y axis once, in `copies` copies.
///
/// **Profile**: M points (x, y), x ≥ 0 the distance from the axis, y the height. Going up, it has its outside on the
/// right. **Copies**: N of them, copy i turned by 2π i / (N - 1), counter-clockwise seen from +y: the point (x, y) goes
/// to (x cos, y, -x sin). The last copy lies exactly, bit for bit, where the first one does: it is a copy of its own
/// because its s is another.
///
/// **Vertices**: M N, copy by copy: point j of copy i is vertex i M + j. **Texture coordinates**: s = i / (N - 1); t is
/// the length of the profile up to the point, over its whole length.
///
/// **Triangles**: for i = 0 … N - 2, for j = 0 … M - 2, with a = i M + j and b = a + M: (a, b, b + 1), (a, b + 1, a +
/// 1), counter-clockwise seen from the right of the profile. Left out are those that have no area: the first if x of
/// point j is 0, the second if x of point j + 1 is 0 (a pole), both if the two points coincide.
///
/// **Normals**: of a stretch of the profile from p to q, (dy, -dx) / |q - p| with (dx, dy) = q - p; stretches of length
/// 0 have none. A point has the direction of the sum of those of the stretch before it and the one after it, turned
/// like the point. So a point that stands twice in the profile makes a crease. On the axis (x = 0) the normal is that
/// of all copies together: the sum without its x part. Where the sum is shorter than 10⁻⁶, the normal is zero.
///
/// Throws std::invalid_argument if M < 2, N < 4, a coordinate is not finite, an x is negative, or all points coincide.
/// The reference: positions within 1 ulp of the point's x, heights as given, s and t within 1 ulp, however many points
/// and copies.
/// Course: lab 3 ("objetos por revolución"), lab 4 ("asignación de coordenadas de textura").
[[nodiscard]] TexturedMesh revolve(std::span<const glm::vec2> profile, std::uint32_t copies);

}
