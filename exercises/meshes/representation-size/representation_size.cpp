#include <umbral/meshes/sizes.hpp>

namespace umbral::meshes {

std::uint64_t voxel_bytes(std::uint64_t k)
{
    // TODO: k³ bits, in whole bytes.
    return not_implemented<std::uint64_t>(k);
}

std::uint64_t sphere_mesh_bytes(std::uint64_t k, const EntryBytes& bytes)
{
    // TODO: k² vertices, and the triangles of k - 1 bands round the sphere.
    return not_implemented<std::uint64_t>(k, bytes);
}

std::uint64_t crossover_resolution(const EntryBytes& bytes)
{
    // TODO: the first k for which the mesh is smaller than the voxels.
    return not_implemented<std::uint64_t>(bytes);
}

GridCounts grid_counts(std::uint64_t columns, std::uint64_t rows)
{
    // TODO: vertices, edges and triangles of a grid.
    return not_implemented<GridCounts>(columns, rows);
}

GridBytes grid_bytes(std::uint64_t columns, std::uint64_t rows, const EntryBytes& bytes)
{
    // TODO: the grid as isolated triangles, indexed, as strips, and as indexed strips.
    return not_implemented<GridBytes>(columns, rows, bytes);
}

GridWork grid_work(std::uint64_t columns, std::uint64_t rows)
{
    // TODO: how many vertices are transformed.
    return not_implemented<GridWork>(columns, rows);
}

}
