#include <cmath>
#include <numbers>
#include <umbral/meshes/builders.hpp>

#include "wide.hpp"

// Positions with at least 64 bits, rounded to float once; triangles by walking round each vertex's lower left cell;
// voxels with 113 bits.

namespace umbral::meshes {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

}

IndexedMesh make_grid(std::uint32_t columns, std::uint32_t rows)
{
    IndexedMesh mesh;
    if (columns == 0 || rows == 0) return mesh;
    const std::uint32_t across = columns + 1;
    for (std::uint32_t i = 0; i < across * (rows + 1); ++i) {
        mesh.positions.emplace_back(static_cast<long double>(i % across) / static_cast<long double>(columns),
                                    static_cast<long double>(i / across) / static_cast<long double>(rows), 0);
        if (i % across == 0 || i < across) continue;
        mesh.triangles.emplace_back(i - across - 1, i - across, i);
        mesh.triangles.emplace_back(i - 1, i - across - 1, i);
    }
    return mesh;
}

IndexedMesh make_sphere(std::uint32_t slices, std::uint32_t stacks)
{
    IndexedMesh mesh;
    if (slices < 3 || stacks < 2) return mesh;
    const std::uint32_t south = slices * (stacks - 1) + 1;
    for (std::uint32_t i = 0; i <= south; ++i) {
        const long double latitude =
            i == 0 ? 0 : pi * static_cast<long double>((i - 1) / slices + 1) / static_cast<long double>(stacks);
        const long double longitude =
            2 * pi * static_cast<long double>((i - 1) % slices) / static_cast<long double>(slices);
        const long double width = i == 0 || i == south ? 0 : std::sin(latitude) / 2;
        mesh.positions.emplace_back(width * std::sin(longitude),
                                    i == south ? static_cast<long double>(-0.5) : std::cos(latitude) / 2,
                                    width * std::cos(longitude));
    }
    for (std::uint32_t i = 1; i < south; ++i) {
        const std::uint32_t east = i % slices == 0 ? i + 1 - slices : i + 1;
        if (i <= slices) mesh.triangles.emplace_back(i, east, 0);
        if (i + slices >= south) {
            mesh.triangles.emplace_back(east, i, south);
            continue;
        }
        mesh.triangles.emplace_back(i, i + slices, east);
        mesh.triangles.emplace_back(i + slices, east + slices, east);
    }
    return mesh;
}

bool voxel_is_inside(std::uint32_t k, const glm::uvec3& cell)
{
    Wide square = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Wide distance = Wide(cell[axis]) + Wide(0.5) - Wide(k) / 2;
        square += distance * distance;
    }
    return square <= Wide(k) * Wide(k) / 4;
}

std::vector<std::uint8_t> make_voxel_sphere(std::uint32_t k)
{
    const std::size_t count = std::size_t{k} * k * k;
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 8 == 0) bytes.push_back(0);
        const glm::uvec3 cell(i % k, i / k % k, i / k / k);
        if (voxel_is_inside(k, cell)) bytes.back() = static_cast<std::uint8_t>(bytes.back() + (1U << i % 8));
    }
    return bytes;
}

}
