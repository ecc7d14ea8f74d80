// alternative: a map from (from, to) to the side of a face, as half-edges have it; edges are the sides that go up
#include <map>
#include <set>
#include <umbral/meshes/winged_edge.hpp>

namespace umbral::meshes {
namespace {

using Ends = std::pair<std::uint32_t, std::uint32_t>;

struct FoundEdge {
    int faces = 0;
    int upward = 0;
};

std::uint32_t next_round_face(const WingedMesh& mesh, std::uint32_t edge, std::uint32_t face)
{
    return mesh.edges[edge].left == face ? mesh.edges[edge].left_next : mesh.edges[edge].right_next;
}

std::uint32_t next_round_vertex(const WingedMesh& mesh, std::uint32_t edge, std::uint32_t vertex)
{
    return mesh.edges[edge].start == vertex ? mesh.edges[edge].left_previous : mesh.edges[edge].right_previous;
}

}

std::variant<WingedMesh, NotWinged> winged_edges(const PolygonMesh& mesh)
{
    std::map<Ends, FoundEdge> found;
    std::vector<std::size_t> degrees(mesh.positions.size(), 0);
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        const auto& face = mesh.faces[f];
        const std::set<std::uint32_t> corners(face.begin(), face.end());
        if (face.size() < 3 || corners.size() < face.size() || *corners.rbegin() >= mesh.positions.size())
            return NotWinged{WingedFault::face, f, f};
        for (std::size_t i = 0; i < face.size(); ++i) {
            const std::uint32_t from = face[i];
            const std::uint32_t to = face[(i + 1) % face.size()];
            FoundEdge& edge = found[std::minmax(from, to)];
            ++edge.faces;
            edge.upward += from < to ? 1 : 0;
            ++degrees[from];
        }
    }
    for (const WingedFault fault : {WingedFault::crowded_edge, WingedFault::open_edge, WingedFault::incoherent_edge})
        for (const auto& [ends, edge] : found) {
            const WingedFault own = edge.faces > 2     ? WingedFault::crowded_edge
                                    : edge.faces == 1  ? WingedFault::open_edge
                                    : edge.upward != 1 ? WingedFault::incoherent_edge
                                                       : WingedFault::pinched_vertex;
            if (own == fault) return NotWinged{fault, ends.first, ends.second};
        }
    for (std::uint32_t vertex = 0; vertex < degrees.size(); ++vertex)
        if (degrees[vertex] == 0) return NotWinged{WingedFault::lonely_vertex, vertex, vertex};

    WingedMesh result{{}, std::vector<std::uint32_t>(degrees.size()), std::vector<std::uint32_t>(mesh.faces.size())};
    std::map<Ends, std::uint32_t> numbers;
    for (const auto& [ends, edge] : found) {
        numbers.emplace_hint(numbers.end(), ends, static_cast<std::uint32_t>(result.edges.size()));
        result.edges.push_back({ends.first, ends.second, 0, 0, 0, 0, 0, 0});
    }
    for (std::uint32_t i = static_cast<std::uint32_t>(result.edges.size()); i-- > 0;)
        result.edge_of_vertex[result.edges[i].start] = result.edge_of_vertex[result.edges[i].end] = i;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        std::vector<std::uint32_t> round;
        const auto& face = mesh.faces[f];
        for (std::size_t i = 0; i < face.size(); ++i)
            round.push_back(numbers.at(std::minmax(face[i], face[(i + 1) % face.size()])));
        result.edge_of_face[f] = *std::min_element(round.begin(), round.end());
        for (std::size_t i = 0; i < round.size(); ++i) {
            WingedEdge& e = result.edges[round[i]];
            const std::uint32_t previous = i == 0 ? round.back() : round[i - 1];
            const std::uint32_t next = i + 1 == round.size() ? round.front() : round[i + 1];
            if (e.start == face[i])
                e = {e.start, e.end, f, e.right, previous, next, e.right_previous, e.right_next};
            else
                e = {e.start, e.end, e.left, f, e.left_previous, e.left_next, previous, next};
        }
    }
    for (std::uint32_t vertex = 0; vertex < degrees.size(); ++vertex) {
        std::size_t steps = 0;
        std::uint32_t edge = result.edge_of_vertex[vertex];
        do {
            edge = next_round_vertex(result, edge, vertex);
            ++steps;
        } while (edge != result.edge_of_vertex[vertex]);
        if (steps != degrees[vertex]) return NotWinged{WingedFault::pinched_vertex, vertex, vertex};
    }
    return result;
}

std::vector<std::uint32_t> edges_round_face(const WingedMesh& mesh, std::uint32_t face)
{
    std::vector<std::uint32_t> edges{mesh.edge_of_face[face]};
    for (std::uint32_t e = next_round_face(mesh, edges[0], face); e != edges[0]; e = next_round_face(mesh, e, face))
        edges.push_back(e);
    return edges;
}

std::vector<std::uint32_t> vertices_round_face(const WingedMesh& mesh, std::uint32_t face)
{
    std::vector<std::uint32_t> result;
    for (const std::uint32_t edge : edges_round_face(mesh, face))
        result.push_back(mesh.edges[edge].left == face ? mesh.edges[edge].start : mesh.edges[edge].end);
    return result;
}

std::vector<std::uint32_t> faces_round_face(const WingedMesh& mesh, std::uint32_t face)
{
    std::vector<std::uint32_t> result;
    for (const std::uint32_t edge : edges_round_face(mesh, face))
        result.push_back(mesh.edges[edge].left + mesh.edges[edge].right - face);
    return result;
}

std::vector<std::uint32_t> edges_round_vertex(const WingedMesh& mesh, std::uint32_t vertex)
{
    std::vector<std::uint32_t> edges{mesh.edge_of_vertex[vertex]};
    for (std::uint32_t e = next_round_vertex(mesh, edges[0], vertex); e != edges[0];
         e = next_round_vertex(mesh, e, vertex))
        edges.push_back(e);
    return edges;
}

std::vector<std::uint32_t> vertices_round_vertex(const WingedMesh& mesh, std::uint32_t vertex)
{
    std::vector<std::uint32_t> result;
    for (const std::uint32_t edge : edges_round_vertex(mesh, vertex))
        result.push_back(mesh.edges[edge].start + mesh.edges[edge].end - vertex);
    return result;
}

std::vector<std::uint32_t> faces_round_vertex(const WingedMesh& mesh, std::uint32_t vertex)
{
    std::vector<std::uint32_t> result;
    for (const std::uint32_t edge : edges_round_vertex(mesh, vertex))
        result.push_back(mesh.edges[edge].start == vertex ? mesh.edges[edge].left : mesh.edges[edge].right);
    return result;
}

}
