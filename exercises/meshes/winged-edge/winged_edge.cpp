#include <umbral/meshes/winged_edge.hpp>

namespace umbral::meshes {

std::variant<WingedMesh, NotWinged> winged_edges(const PolygonMesh& mesh)
{
    // TODO: find the edges, sorted by (start, end), and the one or two or more faces that run along each.
    // Return NotWinged{WingedFault::…, a, b} for the first fault there is. Otherwise fill in both sides of each edge,
    // face by face.
    return not_implemented<std::variant<WingedMesh, NotWinged>>(mesh);
}

std::vector<std::uint32_t> edges_round_face(const WingedMesh& mesh, std::uint32_t face)
{
    // TODO: begin at mesh.edge_of_face[face]; go on by left_next or right_next, whichever side the face is on, until
    // you are back.
    return not_implemented<std::vector<std::uint32_t>>(mesh, face);
}

std::vector<std::uint32_t> vertices_round_face(const WingedMesh& mesh, std::uint32_t face)
{
    // TODO: where each edge round the face begins.
    return not_implemented<std::vector<std::uint32_t>>(mesh, face);
}

std::vector<std::uint32_t> faces_round_face(const WingedMesh& mesh, std::uint32_t face)
{
    // TODO: what is on the other side of each edge round the face.
    return not_implemented<std::vector<std::uint32_t>>(mesh, face);
}

std::vector<std::uint32_t> edges_round_vertex(const WingedMesh& mesh, std::uint32_t vertex)
{
    // TODO: begin at mesh.edge_of_vertex[vertex]; which of the four neighbours of an edge is the next one round its
    // start? And round its end?
    return not_implemented<std::vector<std::uint32_t>>(mesh, vertex);
}

std::vector<std::uint32_t> vertices_round_vertex(const WingedMesh& mesh, std::uint32_t vertex)
{
    // TODO: the other end of each edge.
    return not_implemented<std::vector<std::uint32_t>>(mesh, vertex);
}

std::vector<std::uint32_t> faces_round_vertex(const WingedMesh& mesh, std::uint32_t vertex)
{
    // TODO: the face that lies counter-clockwise of each edge.
    return not_implemented<std::vector<std::uint32_t>>(mesh, vertex);
}

}
