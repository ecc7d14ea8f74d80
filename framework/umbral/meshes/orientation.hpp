#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

namespace umbral::meshes {

// In all of these a triangle names three different vertices, and all of them exist. Two triangles are neighbours if
// they share an edge that no third one has; a piece of a mesh is what hangs together over neighbours. Everything takes
// time in proportion to vertices plus triangles, up to a logarithm.

/// What keeps a mesh from being a 2-manifold; it is one if all lists are empty.
struct ManifoldFaults {
    std::vector<glm::uvec2> crowded_edges;       ///< edges (a, b), a < b, with three triangles or more; sorted
    std::vector<std::uint32_t> lonely_vertices;  ///< without triangles; increasing
    /// Vertices whose triangles are several groups, instead of one fan or one ring. A group hangs together over edges
    /// at the vertex, with however many triangles. Increasing.
    std::vector<std::uint32_t> torn_vertices;
};

/// Course: "características de las 2-variedades".
[[nodiscard]] ManifoldFaults manifold_faults(const IndexedMesh& mesh);

/// The triangles wound so that neighbours agree: one runs along their edge from a to b, and the other from b to a.
///
/// In the order of the mesh; each is the old one, or the old one turned over. The first triangle of each piece stays as
/// it is. Nothing if there is no such winding: a piece has one side only, as a Möbius strip has. Course: "orientación
/// coherente".
[[nodiscard]] std::optional<std::vector<glm::uvec3>> coherent_triangles(const IndexedMesh& mesh);

/// The triangles wound so that closed pieces look outwards: seen from outside they are counter-clockwise, and the
/// volume that the piece encloses is positive.
///
/// Neighbours in `mesh` agree already. A piece is closed if each of its triangles has three neighbours. Each closed
/// piece is a body of its own, also one that lies within another one (not a hollow of it); it is turned over as a
/// whole, or not at all. Pieces that are open, or enclose no volume, stay as they are. In the order of the mesh. The
/// reference's sign is right if the volume is more than 10⁻¹³ of its bounding box's, wherever the piece lies. Course:
/// "una cara vista desde el exterior presenta sus vértices en sentido anti-horario".
[[nodiscard]] std::vector<glm::uvec3> outward_triangles(const IndexedMesh& mesh);

/// The same surface as a 2-manifold (but for lonely vertices, which stay): vertices are doubled, never moved.
///
/// At each vertex, triangles hang together over neighbours that share an edge with this vertex; one such group keeps
/// the vertex, and each other one gets a copy of its own, in the same place. Copies come after all old vertices, in any
/// order; triangles keep their order, winding and first corner. Course: "conversión en 2-variedad": two cones with one
/// apex, two cubes with one edge.
[[nodiscard]] IndexedMesh separated(const IndexedMesh& mesh);

}
