#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

namespace umbral::meshes {

/// The unit square of the xy-plane as a grid of `columns` x `rows` cells, its front towards +z.
///
/// Vertex (i, j) in column i from the left and row j from below, 0 <= i <= columns, 0 <= j <= rows, has the place j
/// (columns + 1) + i in the table, and the position (i/columns, j/rows, 0). Each cell is cut from its lower left corner
/// to its upper right one into two triangles, counter-clockwise. Triangles may stand in any order and begin with any of
/// their corners. Empty if there are no columns or no rows. Guarantee of the reference: positions are the floats
/// nearest to these fractions. Course: problem 2.2.
[[nodiscard]] IndexedMesh make_grid(std::uint32_t columns, std::uint32_t rows);

/// The sphere of radius 1/2 about the origin, by meridians and parallels: `slices` (3 or more) round the y axis,
/// `stacks` (2 or more) from pole to pole.
///
/// Vertex 0 is the north pole (0, 1/2, 0). Then come the stacks - 1 parallels from north to south, r = 1 … stacks - 1,
/// each of `slices` vertices, c = 0 … slices - 1:
///     1/2 (sinθ sinφ, cosθ, sinθ cosφ),   θ = πr/stacks, φ = 2πc/slices,
/// and last the south pole (0, -1/2, 0): slices (stacks - 1) + 2 vertices. Cells between two parallels are cut as the
/// grid's are, from lower left to upper right, seen from outside with north up; at the poles they are triangles. So the
/// mesh is closed, all of its 2 slices (stacks - 1) triangles are counter-clockwise seen from outside, and none is
/// degenerate. The order of triangles is free, as in a grid. Empty if `slices` or `stacks` is too small. Guarantee of
/// the reference: coordinates are off by less than 1.6e-8, one rounding of a float below 1/2. Course: problem 2.1 (b),
/// with each pole stored once.
[[nodiscard]] IndexedMesh make_sphere(std::uint32_t slices, std::uint32_t stacks);

/// Whether the centre of a voxel lies in the ball of radius 1/2 about the origin, or on its surface.
///
/// The ball's bounding cube is cut into k x k x k voxels, k at most 2^30; the centre of `cell` is (x + 1/2, y + 1/2, z
/// + 1/2)/k - (1/2, 1/2, 1/2), each of x, y, z less than k. The reference is exact. Course: problem 2.1 (a),
/// "enumeración espacial".
[[nodiscard]] bool voxel_is_inside(std::uint32_t k, const glm::uvec3& cell);

/// All voxels of that ball, one bit each: (k³ + 7)/8 bytes, rounded down, k at most 1024.
///
/// Voxel (x, y, z) has the number i = x + k (y + k z), and the bit of value 2^(i mod 8) in byte i/8; it is 1 inside.
/// Bits after the last voxel are 0. Course: problem 2.1 (a).
[[nodiscard]] std::vector<std::uint8_t> make_voxel_sphere(std::uint32_t k);

}
