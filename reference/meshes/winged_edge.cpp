// Based on: B. G. Baumgart. Winged Edge Polyhedron Representation. Stanford University, CS-320, 1972. The edges are
// matched by a radix sort: D. E. Knuth. The Art of Computer Programming, volume 3, section 5.2.5, 1973.

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <umbral/meshes/winged_edge.hpp>

namespace umbral::meshes {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A face's way along one of its edges: from corner `from` to the next one, `to`.
struct Side {
    std::uint32_t face, from, to;
    std::size_t previous, next;  ///< the sides before and after it round the face
    std::uint32_t edge = 0;

    [[nodiscard]] std::uint32_t low() const { return std::min(from, to); }
    [[nodiscard]] std::uint32_t high() const { return std::max(from, to); }
};

bool is_face(const std::vector<std::uint32_t>& face, std::uint32_t number, std::size_t vertices,
             std::vector<std::uint32_t>& last_face)
{
    if (face.size() < 3) return false;
    for (const std::uint32_t corner : face) {
        if (corner >= vertices || last_face[corner] == number) return false;
        last_face[corner] = number;
    }
    return true;
}

std::vector<Side> sides_of(const PolygonMesh& mesh)
{
    std::vector<Side> sides;
    for (std::uint32_t number = 0; number < mesh.faces.size(); ++number) {
        const std::vector<std::uint32_t>& face = mesh.faces[number];
        const std::size_t first = sides.size();
        const std::size_t count = face.size();
        for (std::size_t i = 0; i < count; ++i)
            sides.push_back(
                {number, face[i], face[(i + 1) % count], first + (i + count - 1) % count, first + (i + 1) % count});
    }
    return sides;
}

/// Stable, by keys below `keys`, in one pass.
template <class Key>
std::vector<std::size_t> sorted(const std::vector<std::size_t>& order, std::size_t keys, Key key)
{
    std::vector<std::size_t> next(keys + 1, 0);
    for (const std::size_t i : order) ++next[key(i) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<std::size_t> result(order.size());
    for (const std::size_t i : order) result[next[key(i)]++] = i;
    return result;
}

}

std::variant<WingedMesh, NotWinged> winged_edges(const PolygonMesh& mesh)
{
    const std::size_t vertices = mesh.positions.size();
    std::vector<std::uint32_t> last_face(vertices, none);
    for (std::uint32_t number = 0; number < mesh.faces.size(); ++number)
        if (!is_face(mesh.faces[number], number, vertices, last_face))
            return NotWinged{WingedFault::face, number, number};

    // Sides of the same edge come to lie beside each other, in the order of (start, end).
    std::vector<Side> sides = sides_of(mesh);
    std::vector<std::size_t> order(sides.size());
    std::iota(order.begin(), order.end(), 0);
    order = sorted(order, vertices, [&](std::size_t i) { return sides[i].high(); });
    order = sorted(order, vertices, [&](std::size_t i) { return sides[i].low(); });
    const auto is_same = [&](std::size_t i, std::size_t j) {
        return sides[i].low() == sides[j].low() && sides[i].high() == sides[j].high();
    };

    std::optional<NotWinged> fault;
    const auto find = [&](WingedFault what, std::uint32_t a, std::uint32_t b) {
        if (!fault || what < fault->fault) fault = NotWinged{what, a, b};
    };
    WingedMesh result;
    for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
        while (last < order.size() && is_same(order[first], order[last]))
            sides[order[last++]].edge = static_cast<std::uint32_t>(result.edges.size());
        const Side& side = sides[order[first]];
        if (last - first > 2) find(WingedFault::crowded_edge, side.low(), side.high());
        if (last - first == 1) find(WingedFault::open_edge, side.low(), side.high());
        if (last - first == 2 && side.from == sides[order[first + 1]].from)
            find(WingedFault::incoherent_edge, side.low(), side.high());
        result.edges.push_back({side.low(), side.high(), 0, 0, 0, 0, 0, 0});
    }
    for (std::uint32_t vertex = 0; vertex < vertices; ++vertex)
        if (last_face[vertex] == none) find(WingedFault::lonely_vertex, vertex, vertex);
    if (fault) return *fault;

    result.edge_of_face.assign(mesh.faces.size(), none);
    result.edge_of_vertex.assign(vertices, none);
    std::vector<std::size_t> degrees(vertices, 0);
    for (const Side& side : sides) {
        WingedEdge& edge = result.edges[side.edge];
        const std::uint32_t previous = sides[side.previous].edge;
        const std::uint32_t next = sides[side.next].edge;
        if (side.from == edge.start)
            edge.left = side.face, edge.left_previous = previous, edge.left_next = next;
        else
            edge.right = side.face, edge.right_previous = previous, edge.right_next = next;
        result.edge_of_face[side.face] = std::min(result.edge_of_face[side.face], side.edge);
        result.edge_of_vertex[side.from] = std::min(result.edge_of_vertex[side.from], side.edge);
        ++degrees[side.from];
    }
    for (std::uint32_t vertex = 0; vertex < vertices; ++vertex)
        if (edges_round_vertex(result, vertex).size() < degrees[vertex])
            return NotWinged{WingedFault::pinched_vertex, vertex, vertex};
    return result;
}

std::vector<std::uint32_t> edges_round_face(const WingedMesh& mesh, std::uint32_t face)
{
    std::vector<std::uint32_t> edges;
    std::uint32_t edge = mesh.edge_of_face[face];
    do {
        edges.push_back(edge);
        const WingedEdge& e = mesh.edges[edge];
        edge = e.left == face ? e.left_next : e.right_next;
    } while (edge != edges.front());
    return edges;
}

std::vector<std::uint32_t> vertices_round_face(const WingedMesh& mesh, std::uint32_t face)
{
    std::vector<std::uint32_t> list = edges_round_face(mesh, face);
    for (std::uint32_t& item : list)
        item = mesh.edges[item].left == face ? mesh.edges[item].start : mesh.edges[item].end;
    return list;
}

std::vector<std::uint32_t> faces_round_face(const WingedMesh& mesh, std::uint32_t face)
{
    std::vector<std::uint32_t> list = edges_round_face(mesh, face);
    for (std::uint32_t& item : list)
        item = mesh.edges[item].left == face ? mesh.edges[item].right : mesh.edges[item].left;
    return list;
}

std::vector<std::uint32_t> edges_round_vertex(const WingedMesh& mesh, std::uint32_t vertex)
{
    std::vector<std::uint32_t> edges;
    std::uint32_t edge = mesh.edge_of_vertex[vertex];
    do {
        // Leaving the vertex along the edge, the face on the left came in along the next one.
        edges.push_back(edge);
        const WingedEdge& e = mesh.edges[edge];
        edge = e.start == vertex ? e.left_previous : e.right_previous;
    } while (edge != edges.front());
    return edges;
}

std::vector<std::uint32_t> vertices_round_vertex(const WingedMesh& mesh, std::uint32_t vertex)
{
    std::vector<std::uint32_t> list = edges_round_vertex(mesh, vertex);
    for (std::uint32_t& item : list)
        item = mesh.edges[item].start == vertex ? mesh.edges[item].end : mesh.edges[item].start;
    return list;
}

std::vector<std::uint32_t> faces_round_vertex(const WingedMesh& mesh, std::uint32_t vertex)
{
    std::vector<std::uint32_t> list = edges_round_vertex(mesh, vertex);
    for (std::uint32_t& item : list)
        item = mesh.edges[item].start == vertex ? mesh.edges[item].left : mesh.edges[item].right;
    return list;
}

}
