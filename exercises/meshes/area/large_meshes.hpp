#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <kit/varied.hpp>
#include <umbral/core/random.hpp>
#include <umbral/meshes/mesh.hpp>
#include <utility>

#include "../support.hpp"

/// Meshes of many triangles, whose areas are hard to add up.
namespace umbral::meshes {

/// A square of 1000 x 1000, and after it a sheet of 40 x 40 of 2 n² triangles: a float that holds the area of the
/// square takes up none of them where n is 400.
inline IndexedMesh sheet_after_a_square(std::uint32_t cells)
{
    IndexedMesh mesh = sheet(cells, cells, [&](std::uint32_t column, std::uint32_t row) {
        return 40.0F / static_cast<float>(cells) * glm::vec3(static_cast<float>(column), 0, static_cast<float>(row));
    });
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{0, 1, 0}, {0, 1, 1000}, {1000, 1, 1000}, {1000, 1, 0}});
    mesh.triangles.insert(mesh.triangles.begin(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
    return mesh;
}

/// A sheet whose cells grow from a millionth to a few hundred in length; their order says nothing.
inline IndexedMesh sheet_of_all_sizes(std::uint32_t cells, Random& random)
{
    IndexedMesh mesh = sheet(cells, cells, [&](std::uint32_t column, std::uint32_t row) {
        const auto grown = [&](std::uint32_t cell) { return std::pow(10.0, 10.0 * cell / cells - 6); };
        return glm::vec3(glm::dvec3(grown(column), 0.1 * random.uniform_double(), grown(row)));
    });
    mesh.triangles = in_random_order(random, std::move(mesh.triangles));
    return mesh;
}

}
