#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

namespace umbral::meshes {

/// A mesh whose faces have any number of corners: what files hold, and what winged edges take.
///
/// A face holds the places of its corners in `positions`, all less than `positions.size()`, counter-clockwise seen from
/// its front. Nothing else is promised: faces may have fewer than three corners, name a vertex twice, or not be flat.
/// Course: "malla de polígonos".
struct PolygonMesh {
    std::vector<glm::vec3> positions;
    std::vector<std::vector<std::uint32_t>> faces;
};

/// The triangles (first, i, i + 1) of every face, in order; faces with fewer than three corners give none.
///
/// Where a face is not flat the choice of diagonals matters: the course's example of a PLY file has area 9.087 cut in
/// this way, and 9.028 cut in the other.
[[nodiscard]] inline IndexedMesh fan_triangles(const PolygonMesh& mesh)
{
    IndexedMesh result{mesh.positions, {}};
    for (const std::vector<std::uint32_t>& face : mesh.faces)
        for (std::size_t i = 2; i < face.size(); ++i) result.triangles.emplace_back(face[0], face[i - 1], face[i]);
    return result;
}

}
