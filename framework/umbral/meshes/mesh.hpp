#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace umbral::meshes {

/// An indexed triangle mesh: the course's table of vertices and table of triangles.
///
/// A triangle holds the places of its corners in `positions`, all less than `positions.size()`, counter-clockwise seen
/// from its front. Nothing else is promised: triangles may be degenerate, vertices may be used by no triangle, and the
/// mesh may be open or not a manifold. Course: "mallas indexadas".
struct IndexedMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
};

}
