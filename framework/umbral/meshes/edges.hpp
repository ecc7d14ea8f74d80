#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

namespace umbral::meshes {

/// Every edge of any mesh, once: the pairs of vertices that follow each other round a triangle.
///
/// The order of the edges, and of the two vertices of each, is free. Triangles may be wound anyhow, edges may have one
/// triangle or many. A triangle that names a vertex twice has no edges. Takes time and memory in proportion to vertices
/// plus triangles where no vertex has more than a dozen edges or so, and may take longer elsewhere (the reference does
/// not). Course: "tabla de aristas", problem 2.5, first case.
[[nodiscard]] std::vector<glm::uvec2> edge_table(const IndexedMesh& mesh);

/// The same for a mesh that is closed and coherently wound: every edge has exactly two triangles, one of which runs
/// along it from a to b, and the other from b to a, and no triangle names a vertex twice.
///
/// What it does with other meshes is not defined. Takes time in proportion to the triangles, and no more memory than
/// that of the result and of what it needs to grow. Course: "tabla de aristas", problem 2.5, second case.
[[nodiscard]] std::vector<glm::uvec2> edge_table_of_closed(const IndexedMesh& mesh);

}
