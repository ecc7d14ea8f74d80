#pragma once

#include <cstdint>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/polygons.hpp>
#include <variant>
#include <vector>

namespace umbral::meshes {

/// An entry of the edge table. Walking from `start` to `end`, seen from outside, one face is on the left and one on the
/// right.
///
/// Faces are walked round counter-clockwise: the left one along this edge from start to end, the right one from end to
/// start. So `left_next` begins at `end`, and `right_next` begins at `start`. Course: vi, vf; ti, td; aai, asi; aad,
/// asd.
struct WingedEdge {
    std::uint32_t start, end;
    std::uint32_t left, right;                 ///< faces
    std::uint32_t left_previous, left_next;    ///< the edges before and after this one round the left face
    std::uint32_t right_previous, right_next;  ///< the edges before and after this one round the right face
};

/// The three tables of winged edges. The course leaves the choice of start and end, and of one edge for each vertex and
/// face; here they are fixed, so that there is one answer: start < end, the edges are sorted by (start, end), and each
/// vertex and face has the smallest of its edges. Course: "tari", "taver", "tatri".
struct WingedMesh {
    std::vector<WingedEdge> edges;
    std::vector<std::uint32_t> edge_of_vertex;
    std::vector<std::uint32_t> edge_of_face;
};

/// Why a mesh has no winged edges, in the order in which they are looked for.
enum class WingedFault {
    face = 1,             ///< a face has fewer than three corners, names a vertex twice, or names one that there is not
    crowded_edge = 2,     ///< an edge has more than two faces
    open_edge = 3,        ///< an edge has one face only: the mesh encloses nothing
    incoherent_edge = 4,  ///< both faces of an edge run along it in the same direction
    lonely_vertex = 5,    ///< a vertex has no face
    pinched_vertex = 6,   ///< the faces of a vertex are not one ring, but several
};

/// The first of the faults, and where: the face or vertex of the smallest number (then a = b), or the edge (a, b), a <
/// b, with the smallest a, then b.
struct NotWinged {
    WingedFault fault;
    std::uint32_t a, b;
};

/// The winged edges of a closed, coherently wound 2-manifold, or why it is none.
///
/// Any faces will do: nothing is asked of the mesh before. Two faces may have all their vertices in common. An empty
/// mesh has empty tables. Takes time in proportion to vertices plus corners, also where a vertex has thousands of
/// edges. Course: "estructura de aristas aladas".
[[nodiscard]] std::variant<WingedMesh, NotWinged> winged_edges(const PolygonMesh& mesh);

// Questions about a mesh with winged edges, each answered in time proportional to the answer. Lists are
// counter-clockwise seen from outside, and begin at the edge that the table gives for the face or vertex. Faces and
// vertices must exist.

/// The edges round a face.
[[nodiscard]] std::vector<std::uint32_t> edges_round_face(const WingedMesh& mesh, std::uint32_t face);

/// The corners of a face, as its edges leave them: vertex i is where edge i begins, going round the face.
[[nodiscard]] std::vector<std::uint32_t> vertices_round_face(const WingedMesh& mesh, std::uint32_t face);

/// The neighbours of a face: face i is beyond edge i.
[[nodiscard]] std::vector<std::uint32_t> faces_round_face(const WingedMesh& mesh, std::uint32_t face);

/// The edges at a vertex.
[[nodiscard]] std::vector<std::uint32_t> edges_round_vertex(const WingedMesh& mesh, std::uint32_t vertex);

/// The neighbours of a vertex: vertex i is the other end of edge i.
[[nodiscard]] std::vector<std::uint32_t> vertices_round_vertex(const WingedMesh& mesh, std::uint32_t vertex);

/// The faces at a vertex: face i is between edge i and the next.
[[nodiscard]] std::vector<std::uint32_t> faces_round_vertex(const WingedMesh& mesh, std::uint32_t vertex);

}
