// Based on: the course's problems 2.1 to 2.3. The formulas are counts; none of them is rounded but for the last byte of
// the voxels.

#include <umbral/meshes/sizes.hpp>

namespace umbral::meshes {

std::uint64_t voxel_bytes(std::uint64_t k) { return (k * k * k + 7) / 8; }

std::uint64_t sphere_mesh_bytes(std::uint64_t k, const EntryBytes& bytes)
{
    const std::uint64_t triangles = 2 * k * (k - 1);
    return bytes.vertex * k * k + 3 * bytes.index * triangles;
}

// With S = vertex + 6 index the mesh takes S k² - 6 index k bytes. At k = 8S the voxels take S k²: more, by 6 index k.
// At k = 8S - 1 they take less, by (8S - 1)(vertex - 1/8), and the smaller k is, the more they are behind.
std::uint64_t crossover_resolution(const EntryBytes& bytes) { return 8 * (bytes.vertex + 6 * bytes.index); }

GridCounts grid_counts(std::uint64_t columns, std::uint64_t rows)
{
    const std::uint64_t cells = columns * rows;
    // Each cell has a diagonal, a left and a lower side of its own; the last column and the last row add their outer
    // sides.
    return {(columns + 1) * (rows + 1), 3 * cells + columns + rows, 2 * cells};
}

GridBytes grid_bytes(std::uint64_t columns, std::uint64_t rows, const EntryBytes& bytes)
{
    const GridCounts grid = grid_counts(columns, rows);
    const std::uint64_t in_strips = rows * (2 * columns + 2);
    const std::uint64_t table_of_strips = bytes.index + rows * bytes.pointer;
    return {.isolated = 3 * grid.triangles * bytes.vertex,
            .indexed = grid.vertices * bytes.vertex + 3 * grid.triangles * bytes.index,
            .strips = in_strips * bytes.vertex + table_of_strips,
            .indexed_strips = grid.vertices * bytes.vertex + in_strips * bytes.index + table_of_strips};
}

GridWork grid_work(std::uint64_t columns, std::uint64_t rows)
{
    const GridCounts grid = grid_counts(columns, rows);
    return {.isolated = 3 * grid.triangles, .indexed = grid.vertices, .strips = rows * (2 * columns + 2)};
}

}
