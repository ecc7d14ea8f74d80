#include <umbral/meshes/builders.hpp>

namespace umbral::meshes {

IndexedMesh make_grid(std::uint32_t columns, std::uint32_t rows)
{
    // TODO: (columns + 1) (rows + 1) vertices, row by row from below; two triangles a cell.
    return not_implemented<IndexedMesh>(columns, rows);
}

IndexedMesh make_sphere(std::uint32_t slices, std::uint32_t stacks)
{
    // TODO: north pole, parallels from north to south, south pole; then the triangles, all the way round.
    return not_implemented<IndexedMesh>(slices, stacks);
}

bool voxel_is_inside(std::uint32_t k, const glm::uvec3& cell)
{
    // TODO: the distance from the voxel's centre to the origin, against the radius.
    return not_implemented<bool>(k, cell);
}

std::vector<std::uint8_t> make_voxel_sphere(std::uint32_t k)
{
    // TODO: one bit a voxel, eight of them in a byte.
    return not_implemented<std::vector<std::uint8_t>>(k);
}

}
