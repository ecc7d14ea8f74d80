#include <umbral/meshes/sizes.hpp>

#include "wide.hpp"

// The formulas multiplied out, with 113 bits, in which every number of 64 bits and every sum of them is exact; the
// crossover by halving an interval.
//

namespace umbral::meshes {
namespace {

std::uint64_t whole(Wide value) { return static_cast<std::uint64_t>(value); }

}

std::uint64_t voxel_bytes(std::uint64_t k)
{
    const Wide bits = Wide(k) * Wide(k) * Wide(k);
    const std::uint64_t down = whole(bits / 8);
    return Wide(down) * 8 < bits ? down + 1 : down;
}

std::uint64_t sphere_mesh_bytes(std::uint64_t k, const EntryBytes& bytes)
{
    const Wide side(k);
    return whole(Wide(bytes.vertex + 6 * bytes.index) * side * side - Wide(6 * bytes.index) * side);
}

std::uint64_t crossover_resolution(const EntryBytes& bytes)
{
    std::uint64_t voxels_win = 1;
    std::uint64_t mesh_wins = std::uint64_t{1} << 21;
    while (mesh_wins - voxels_win > 1) {
        const std::uint64_t k = (voxels_win + mesh_wins) / 2;
        (sphere_mesh_bytes(k, bytes) < voxel_bytes(k) ? mesh_wins : voxels_win) = k;
    }
    return mesh_wins;
}

GridCounts grid_counts(std::uint64_t columns, std::uint64_t rows)
{
    const Wide n(columns);
    const Wide m(rows);
    return {whole(n * m + n + m + 1), whole(n * (m + 1) + m * (n + 1) + n * m), whole(2 * n * m)};
}

GridBytes grid_bytes(std::uint64_t columns, std::uint64_t rows, const EntryBytes& bytes)
{
    const Wide n(columns);
    const Wide m(rows);
    const Wide v(bytes.vertex);
    const Wide i(bytes.index);
    const Wide table = i + m * Wide(bytes.pointer);
    return {whole(6 * v * n * m), whole((v + 6 * i) * n * m + v * (n + m + 1)),
            whole(2 * v * n * m + 2 * v * m + table), whole((v + 2 * i) * n * m + v * (n + m + 1) + 2 * i * m + table)};
}

GridWork grid_work(std::uint64_t columns, std::uint64_t rows)
{
    const Wide n(columns);
    const Wide m(rows);
    return {whole(6 * n * m), whole(n * m + n + m + 1), whole(2 * n * m + 2 * m)};
}

}
