// alternative: rows of vertices one above the other, joined by a function that does not know whether they are a grid's
// or a sphere's
#include <cmath>
#include <numbers>
#include <umbral/meshes/builders.hpp>

namespace umbral::meshes {
namespace {

using Row = std::vector<std::uint32_t>;

void join(const Row& lower, const Row& upper, IndexedMesh& mesh)
{
    for (std::size_t i = 1; i < lower.size(); ++i)
        for (const glm::uvec3& t :
             {glm::uvec3(lower[i], upper[i], lower[i - 1]), glm::uvec3(upper[i - 1], lower[i - 1], upper[i])})
            if (t.x != t.y && t.y != t.z && t.z != t.x) mesh.triangles.push_back(t);
}

std::uint32_t added(IndexedMesh& mesh, const glm::dvec3& position)
{
    mesh.positions.emplace_back(position);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

}

IndexedMesh make_grid(std::uint32_t columns, std::uint32_t rows)
{
    IndexedMesh mesh;
    if (columns * std::uint64_t{rows} == 0) return mesh;
    Row last;
    for (std::uint32_t j = 0; j <= rows; ++j) {
        Row row;
        for (std::uint32_t i = 0; i <= columns; ++i)
            row.push_back(added(mesh, {i / double(columns), j / double(rows), 0}));
        if (j > 0) join(last, row, mesh);
        last = row;
    }
    return mesh;
}

IndexedMesh make_sphere(std::uint32_t slices, std::uint32_t stacks)
{
    IndexedMesh mesh;
    if (slices < 3 || stacks < 2) return mesh;
    Row upper(slices + 1, added(mesh, {0, 0.5, 0}));
    for (std::uint32_t ring = 1; ring <= stacks; ++ring) {
        Row row;
        const double latitude = std::numbers::pi * ring / stacks;
        for (std::uint32_t slice = 0; slice < slices && ring < stacks; ++slice) {
            const double longitude = std::numbers::pi * 2 * slice / slices;
            row.push_back(added(mesh, 0.5 * glm::dvec3(std::sin(latitude) * std::sin(longitude), std::cos(latitude),
                                                       std::sin(latitude) * std::cos(longitude))));
        }
        if (ring == stacks) row.assign(slices, added(mesh, {0, -0.5, 0}));
        row.push_back(row.front());
        join(row, upper, mesh);
        upper = row;
    }
    return mesh;
}

// Where k is even the centres lie half a voxel off the origin, so that all is counted in halves.
bool voxel_is_inside(std::uint32_t k, const glm::uvec3& cell)
{
    std::uint64_t sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint64_t twice = 2 * std::uint64_t{cell[axis]} + 1;
        const std::uint64_t distance = twice > k ? twice - k : k - twice;
        sum += distance * distance;
    }
    return sum <= std::uint64_t{k} * k;
}

std::vector<std::uint8_t> make_voxel_sphere(std::uint32_t k)
{
    std::vector<std::uint8_t> bytes;
    for (std::uint32_t i = 0; i < k * k * k; ++i) {
        if (i % 8 == 0) bytes.push_back(0);
        if (voxel_is_inside(k, {i % k, i / k % k, i / (k * k)}))
            bytes.back() |= static_cast<std::uint8_t>(1U << (i % 8));
    }
    return bytes;
}

}
