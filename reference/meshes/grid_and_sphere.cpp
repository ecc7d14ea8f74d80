// Based on: the course's problems 2.1 and 2.2; J. Foley, A. van Dam, S. Feiner, J. Hughes. Computer Graphics:
// Principles and Practice. 2nd edition, 1990, chapters 11 (meshes) and 12.6 (spatial partitioning).

#include <cmath>
#include <numbers>
#include <umbral/meshes/builders.hpp>

namespace umbral::meshes {
namespace {

/// A cell from its corners: lower left, lower right, upper right, upper left.
void add_cell(IndexedMesh& mesh, const glm::uvec4& corners)
{
    mesh.triangles.emplace_back(corners[0], corners[1], corners[2]);
    mesh.triangles.emplace_back(corners[0], corners[2], corners[3]);
}

}

IndexedMesh make_grid(std::uint32_t columns, std::uint32_t rows)
{
    IndexedMesh mesh;
    if (columns == 0 || rows == 0) return mesh;
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column <= columns; ++column)
            mesh.positions.emplace_back(double(column) / columns, double(row) / rows, 0);
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t below = row * (columns + 1) + column;
            const std::uint32_t above = below + columns + 1;
            add_cell(mesh, {below, below + 1, above + 1, above});
        }
    return mesh;
}

IndexedMesh make_sphere(std::uint32_t slices, std::uint32_t stacks)
{
    IndexedMesh mesh;
    if (slices < 3 || stacks < 2) return mesh;
    mesh.positions.emplace_back(0, 0.5, 0);
    for (std::uint32_t ring = 1; ring < stacks; ++ring)
        for (std::uint32_t slice = 0; slice < slices; ++slice) {
            const double latitude = std::numbers::pi * ring / stacks;  // from the north pole
            const double longitude = 2 * std::numbers::pi * slice / slices;
            mesh.positions.emplace_back(0.5 * std::sin(latitude) * std::sin(longitude), 0.5 * std::cos(latitude),
                                        0.5 * std::sin(latitude) * std::cos(longitude));
        }
    mesh.positions.emplace_back(0, -0.5, 0);

    // The last slice ends where the first one begins.
    const auto at = [&](std::uint32_t ring, std::uint32_t slice) { return 1 + (ring - 1) * slices + slice % slices; };
    const std::uint32_t north = 0;
    const std::uint32_t south = at(stacks, 0);
    for (std::uint32_t slice = 0; slice < slices; ++slice) {
        mesh.triangles.emplace_back(north, at(1, slice), at(1, slice + 1));
        for (std::uint32_t ring = 1; ring + 1 < stacks; ++ring)
            add_cell(mesh, {at(ring + 1, slice), at(ring + 1, slice + 1), at(ring, slice + 1), at(ring, slice)});
        mesh.triangles.emplace_back(south, at(stacks - 1, slice + 1), at(stacks - 1, slice));
    }
    return mesh;
}

// Twice the centre, in voxels, is a whole number, and so is twice the radius: k. No centre lies on the surface, as
// parity shows: three odd squares leave 3 when divided by 8, an even k² does not; three even squares leave 0 when
// divided by 4, an odd k² does not.
bool voxel_is_inside(std::uint32_t k, const glm::uvec3& cell)
{
    const glm::i64vec3 centre = std::int64_t{2} * glm::i64vec3(cell) + std::int64_t{1} - std::int64_t{k};
    return centre.x * centre.x + centre.y * centre.y + centre.z * centre.z <= std::int64_t{k} * k;
}

std::vector<std::uint8_t> make_voxel_sphere(std::uint32_t k)
{
    std::vector<std::uint8_t> bytes((std::size_t{k} * k * k + 7) / 8);
    std::size_t number = 0;
    for (std::uint32_t z = 0; z < k; ++z)
        for (std::uint32_t y = 0; y < k; ++y)
            for (std::uint32_t x = 0; x < k; ++x, ++number)
                if (voxel_is_inside(k, {x, y, z}))
                    bytes[number / 8] = static_cast<std::uint8_t>(bytes[number / 8] | 1U << number % 8);
    return bytes;
}

}
