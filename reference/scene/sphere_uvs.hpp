#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace umbral::scene {

/// Texture coordinates with indices of their own.
struct SphereUvs {
    std::vector<glm::vec2> uvs;         ///< at least one
    std::vector<glm::uvec3> triangles;  ///< places in uvs, one triple for each triangle
};

/// Texture coordinates of a mesh as if it lay on the unit sphere round the origin: each corner has those of the sphere
/// in its direction (see Sphere). Across the seam u goes on beyond 1, so that it does not jump within a triangle,
/// unless that lies at a pole. Every index must be less than positions.size().
[[nodiscard]] SphereUvs sphere_uvs(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

}
