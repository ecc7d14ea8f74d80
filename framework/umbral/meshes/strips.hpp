#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

namespace umbral::meshes {

/// A triangle strip, as places in a table of vertices: every three indices in a row are a triangle, as OpenGL's
/// GL_TRIANGLE_STRIP has it.
///
/// The triangles of indices 0 1 2, 2 3 4, … (the even ones) are wound as they stand, those of 1 2 3, 3 4 5, … (the odd
/// ones) the other way round: 2 1 3, 4 3 5. A triangle that names a vertex twice is drawn by nobody, but counts as one
/// when even and odd are told apart.
using Strip = std::vector<std::uint32_t>;

/// Ends a strip within a list of indices; the next index begins another one, whose first triangle is even. As OpenGL's
/// GL_PRIMITIVE_RESTART_FIXED_INDEX.
inline constexpr std::uint32_t restart_index = 0xFFFFFFFF;

/// One strip for each row of a grid of `columns` x `rows` cells, each of 2 `columns` + 2 indices.
///
/// The grid lies in the xy-plane: vertex (i, j) in column i from the left and row j from below, 0 <= i <= columns, 0 <=
/// j <= rows, has the place j (columns + 1) + i. The strip of a row begins with its upper left vertex, then comes the
/// lower left one, then the next upper one; its triangles are counter-clockwise. Rows come from below to above. Empty
/// if there are no rows or no columns. Course: problem 2.3, "tiras de triángulos (TT)", "tabla de vértices y tiras de
/// triángulos".
[[nodiscard]] std::vector<Strip> grid_strips(std::uint32_t columns, std::uint32_t rows);

/// The triangles of a list of indices in order, without those that name a vertex twice. Each is wound as the strip
/// winds it, and may begin with any of its vertices.
///
/// The list may hold restart_index anywhere. What is left before it or at the end, with fewer than three indices, gives
/// nothing.
[[nodiscard]] std::vector<glm::uvec3> triangles_of_strip(const Strip& indices);

/// One strip with the same triangles in the same order and winding, without restart_index: strips are joined by
/// repeated indices, whose triangles name a vertex twice.
///
/// The last index so far comes once more, then the first one of the next strip; and that once more again if the next
/// strip would begin at an odd place. Strips of fewer than three indices are left out. No index of the input is
/// restart_index.
[[nodiscard]] Strip join_strips(const std::vector<Strip>& strips);

/// Strips that have every triangle of the mesh exactly once, wound as the mesh has it; triangles of the mesh that name
/// a vertex twice need not occur.
///
/// Any such strips are right: their order, number and beginnings are free. The fewer indices they have altogether, the
/// better: as many as triangles and two more a strip. The reference grows each strip from a triangle in three
/// directions, and keeps the longest. Takes time in proportion to vertices plus triangles, but for bad luck with
/// hashing or the log n of sorting. Course: "algoritmos para generar las tiras".
[[nodiscard]] std::vector<Strip> make_strips(const IndexedMesh& mesh);

/// The same strips without a table of vertices: each index is replaced by the position that it names. As many strips as
/// came, in order. All indices are places in `positions`. Course: "tiras de triángulos (TT)".
[[nodiscard]] std::vector<std::vector<glm::vec3>> strips_of_coordinates(const std::vector<glm::vec3>& positions,
                                                                        const std::vector<Strip>& strips);

/// Bytes of strips in two ways. Floats and indices take 4 bytes, pointers 8; both ways have a table of strips: how many
/// there are (4 bytes), and a pointer to each.
struct StripBytes {
    std::uint64_t coordinates;  ///< a position for each index of a strip, and no table of vertices
    std::uint64_t indexed;      ///< the table of vertices, and the indices
};

/// For a mesh of so many vertices, and any strips of it. Course: problem 2.3 (a), "tabla de vértices y tiras de
/// triángulos".
[[nodiscard]] StripBytes strip_bytes(std::uint64_t vertices, const std::vector<Strip>& strips);

}
