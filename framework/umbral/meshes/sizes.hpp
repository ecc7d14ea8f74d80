#pragma once

#include <cstdint>
#include <umbral/core/not_implemented.hpp>

namespace umbral::meshes {

/// What the entries of a mesh's tables take, in bytes; the course's numbers. Each is 1 to 4096.
struct EntryBytes {
    std::uint64_t vertex = 12;  ///< three floats
    std::uint64_t index = 4;
    std::uint64_t pointer = 8;
};

/// Bytes of a cube of k x k x k voxels, one bit each, without gaps but for the last byte: rounded up. k is at most
/// 2^21. Course: problem 2.1 (a).
[[nodiscard]] std::uint64_t voxel_bytes(std::uint64_t k);

/// Bytes of the two tables, vertices and triangles, of a sphere with k vertices in each meridian and k in each
/// parallel, poles included (k of at least 2, at most 2^21).
///
/// k² vertices, also where they coincide at the poles. Between two parallels that follow one another there are k
/// quadrilaterals, all round, of two triangles each. Course: problem 2.1 (b).
[[nodiscard]] std::uint64_t sphere_mesh_bytes(std::uint64_t k, const EntryBytes& bytes = {});

/// The smallest k, 2 or more, for which the sphere's mesh takes fewer bytes than its voxels. From there on it always
/// does. Course: problem 2.1 (iv).
[[nodiscard]] std::uint64_t crossover_resolution(const EntryBytes& bytes = {});

/// What a grid of `columns` x `rows` cells consists of, each cell of two triangles that share a diagonal.
struct GridCounts {
    std::uint64_t vertices, edges, triangles;
};

/// Course: problem 2.2. Columns and rows are at least 1; all results of this header fit into 64 bits.
[[nodiscard]] GridCounts grid_counts(std::uint64_t columns, std::uint64_t rows);

/// Bytes of the same grid, written down in four ways.
struct GridBytes {
    std::uint64_t isolated;  ///< three vertices for each triangle
    std::uint64_t indexed;   ///< a table of vertices, and three indices for each triangle
    std::uint64_t strips;    ///< a strip for each row of cells, 2 columns + 2 vertices long, and the table of strips
    std::uint64_t indexed_strips;  ///< a table of vertices, the same strips but of indices, and the table of strips
};

/// The table of strips holds how many there are (as large as an index) and a pointer for each.
/// Course: problems 2.2 and 2.3 (a), "triángulos aislados", "tabla de vértices y tiras de triángulos".
[[nodiscard]] GridBytes grid_bytes(std::uint64_t columns, std::uint64_t rows, const EntryBytes& bytes = {});

/// How many vertices are transformed to draw the grid, if what is stored is transformed once wherever it is stored.
struct GridWork {
    std::uint64_t isolated, indexed, strips;
};

/// Course: problem 2.3 (c).
[[nodiscard]] GridWork grid_work(std::uint64_t columns, std::uint64_t rows);

}
