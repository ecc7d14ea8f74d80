// alternative: counts band by band and row by row, and looks for the crossover one k after the other
#include <umbral/meshes/sizes.hpp>

namespace umbral::meshes {

std::uint64_t voxel_bytes(std::uint64_t k)
{
    const std::uint64_t bits = k * k * k;
    return bits / 8 + (bits % 8 != 0 ? 1 : 0);
}

std::uint64_t sphere_mesh_bytes(std::uint64_t k, const EntryBytes& bytes)
{
    const std::uint64_t parallel = k * bytes.vertex;
    const std::uint64_t band = 6 * k * bytes.index;
    return parallel + (k - 1) * (parallel + band);
}

std::uint64_t crossover_resolution(const EntryBytes& bytes)
{
    std::uint64_t k = 2;
    while (sphere_mesh_bytes(k, bytes) >= voxel_bytes(k)) ++k;
    return k;
}

GridCounts grid_counts(std::uint64_t columns, std::uint64_t rows)
{
    const std::uint64_t across = columns * (rows + 1);
    const std::uint64_t upright = rows * (columns + 1);
    return {columns * rows + columns + rows + 1, across + upright + columns * rows, columns * rows * 2};
}

GridBytes grid_bytes(std::uint64_t columns, std::uint64_t rows, const EntryBytes& bytes)
{
    const auto [vertices, edges, triangles] = grid_counts(columns, rows);
    const GridWork stored = grid_work(columns, rows);
    const std::uint64_t table = bytes.pointer * rows + bytes.index;
    return {stored.isolated * bytes.vertex, stored.indexed * bytes.vertex + 3 * triangles * bytes.index,
            stored.strips * bytes.vertex + table, vertices * bytes.vertex + stored.strips * bytes.index + table};
}

GridWork grid_work(std::uint64_t columns, std::uint64_t rows)
{
    const std::uint64_t strip = (columns + 1) * 2;
    return {columns * rows * 6, (columns + 1) * (rows + 1), strip * rows};
}

}
