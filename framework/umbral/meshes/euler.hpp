#pragma once

#include <cstdint>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/mesh.hpp>

namespace umbral::meshes {

/// What a mesh consists of. Only the triangles count, never the positions: two vertices in one place are two vertices.
///
/// A triangle that names a vertex twice is no face, and has no edges. Any other one is a face; one that the table holds
/// twice is two.
struct TopologyCounts {
    int vertices;            ///< V: those that at least one face has
    int isolated_vertices;   ///< the others
    int edges;               ///< E: unordered pairs of vertices that follow each other round a face; each counts once
    int faces;               ///< F
    int boundary_edges;      ///< edges of exactly one face; the mesh is closed if there are none
    int non_manifold_edges;  ///< edges of three or more faces
    int boundary_loops;  ///< pieces into which the boundary edges fall; two that share a vertex are in one piece. In a
                         ///< 2-manifold each is a closed curve
    int components;      ///< pieces into which the faces fall; two that share a vertex are in one piece

    friend bool operator==(const TopologyCounts&, const TopologyCounts&) = default;
};

/// Counts them, in time linear in vertices plus triangles where no bad luck with hashing or sorting's log n count.
/// Course: "vértice", "cara", "arista", "arista de frontera", problem 2.4.
[[nodiscard]] TopologyCounts count_topology(const IndexedMesh& mesh);

/// How many handles the surface has: g in V - E + F = 2 c - 2 g - b, with c components and b boundary loops. For
/// several components, the sum of theirs.
///
/// Has a value if the faces form a coherently wound 2-manifold: every edge has one face, or two that run along it in
/// opposite directions, and the faces round each vertex hang together over edges. Else std::nullopt: a bow-tie vertex,
/// three faces at an edge, a surface with one side (a Möbius strip), or one whose winding is mixed, though another
/// winding might do. Isolated vertices do not count. No faces: std::nullopt. Course: "género topológico", "2-variedad",
/// "orientación coherente".
[[nodiscard]] std::optional<int> genus(const IndexedMesh& mesh);

/// V, E and F of one mesh.
struct ElementCounts {
    std::int64_t vertices;
    std::int64_t edges;
    std::int64_t faces;

    friend bool operator==(const ElementCounts&, const ElementCounts&) = default;
};

/// All three counts of a closed triangle mesh that is one piece without handles (a sphere), from one of them: E = 3 (V
/// - 2) and F = 2 (V - 2).
///
/// std::nullopt for a number that no such mesh has. The smallest one is the tetrahedron: 4, 6, 4. Right for all numbers
/// up to 10¹⁸. Course: problem 2.4.
[[nodiscard]] std::optional<ElementCounts> sphere_from_vertices(std::int64_t vertices);
[[nodiscard]] std::optional<ElementCounts> sphere_from_edges(std::int64_t edges);
[[nodiscard]] std::optional<ElementCounts> sphere_from_faces(std::int64_t faces);

}
