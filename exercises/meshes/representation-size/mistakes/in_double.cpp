// mistake: computes with double
// credit: 86..96
// hint: A double has 53 bits: from 9·10¹⁵ on it skips odd numbers, then more. Sizes are whole numbers; keep them in
// std::uint64_t from beginning to end.
#include <cmath>
#include <umbral/meshes/sizes.hpp>

namespace umbral::meshes {
namespace {

std::uint64_t whole(double value) { return static_cast<std::uint64_t>(value); }

double real(std::uint64_t value) { return static_cast<double>(value); }

}

std::uint64_t voxel_bytes(std::uint64_t k) { return whole(std::ceil(std::pow(real(k), 3) / 8)); }

std::uint64_t sphere_mesh_bytes(std::uint64_t k, const EntryBytes& bytes)
{
    return whole(real(bytes.vertex) * std::pow(real(k), 2) + 6 * real(bytes.index) * real(k) * (real(k) - 1));
}

std::uint64_t crossover_resolution(const EntryBytes& bytes) { return 8 * (bytes.vertex + 6 * bytes.index); }

GridCounts grid_counts(std::uint64_t columns, std::uint64_t rows)
{
    const double n = real(columns);
    const double m = real(rows);
    return {whole((n + 1) * (m + 1)), whole(3 * n * m + n + m), whole(2 * n * m)};
}

GridBytes grid_bytes(std::uint64_t columns, std::uint64_t rows, const EntryBytes& bytes)
{
    const double n = real(columns);
    const double m = real(rows);
    const double v = real(bytes.vertex);
    const double i = real(bytes.index);
    const double table = i + m * real(bytes.pointer);
    return {whole(6 * v * n * m), whole(v * (n + 1) * (m + 1) + 6 * i * n * m), whole(m * v * (2 * n + 2) + table),
            whole(v * (n + 1) * (m + 1) + i * m * (2 * n + 2) + table)};
}

GridWork grid_work(std::uint64_t columns, std::uint64_t rows)
{
    return {6 * columns * rows, (columns + 1) * (rows + 1), rows * (2 * columns + 2)};
}

}
