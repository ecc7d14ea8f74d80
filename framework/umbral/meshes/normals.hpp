#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

namespace umbral::meshes {

/// The unit normal of every triangle (a, b, c): the direction of (b - a) × (c - a), by the right-hand rule.
///
/// One entry a triangle, in the order of `mesh.triangles`. Zero for a degenerate triangle: its corners lie on one line,
/// or are not all finite. Course: lab 1, "normales de caras".
[[nodiscard]] std::vector<glm::vec3> face_normals(const IndexedMesh& mesh);

/// The unit normal of every vertex: the direction of the sum of the *unit* normals of the triangles that have it as a
/// corner.
///
/// Every triangle counts alike, whatever its area or angle; degenerate ones count as zero. A triangle that names a
/// vertex twice is degenerate. One entry a vertex, in the order of `mesh.positions`. Zero where the sum is shorter than
/// 10⁻⁶: no triangle has the vertex, or their normals cancel. The reference's guarantee is that of its faces, also
/// where only 1e-5 is left of the sum. Takes time in proportion to vertices plus triangles. Course: lab 1, "normales de
/// vértices".
[[nodiscard]] std::vector<glm::vec3> vertex_normals(const IndexedMesh& mesh);

}
