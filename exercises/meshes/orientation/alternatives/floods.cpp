// alternative: a table of the triangles at each edge, and floods from triangle to triangle instead of joined groups
#include <map>
#include <set>
#include <umbral/meshes/orientation.hpp>

namespace umbral::meshes {
namespace {

using Ends = std::pair<std::uint32_t, std::uint32_t>;
using EdgeMap = std::map<Ends, std::vector<std::uint32_t>>;

EdgeMap triangles_at_edges(const IndexedMesh& mesh)
{
    EdgeMap edges;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k)
            edges[std::minmax(mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3])].push_back(i);
    return edges;
}

bool runs_along(const glm::uvec3& t, std::uint32_t a, std::uint32_t b)
{
    return (t.x == a && t.y == b) || (t.y == a && t.z == b) || (t.z == a && t.x == b);
}

void turn(glm::uvec3& t) { std::swap(t.y, t.z); }

/// The groups of triangles at every vertex: a number for each corner, and how many groups each vertex has.
struct VertexGroups {
    std::vector<glm::uvec3> group_of;
    std::vector<std::uint32_t> counts;
};

VertexGroups groups_at_vertices(const IndexedMesh& mesh, bool over_crowded_edges)
{
    const EdgeMap edges = triangles_at_edges(mesh);
    constexpr std::uint32_t unknown = 4294967295U;
    VertexGroups groups{std::vector<glm::uvec3>(mesh.triangles.size(), glm::uvec3(unknown)),
                        std::vector<std::uint32_t>(mesh.positions.size(), 0)};
    std::set<Ends> used;  // crowded edges from which the flood has gone on, each with the vertex that it ran round
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            if (groups.group_of[i][k] != unknown) continue;
            const std::uint32_t vertex = mesh.triangles[i][k];
            const std::uint32_t number = groups.counts[vertex]++;
            std::vector<std::uint32_t> open{i};
            groups.group_of[i][k] = number;
            while (!open.empty()) {
                const glm::uvec3 t = mesh.triangles[open.back()];
                open.pop_back();
                for (int other = 0; other < 3; ++other) {
                    if (t[other] == vertex) continue;
                    const auto& beside = edges.at(std::minmax(vertex, t[other]));
                    if (beside.size() > 2 && (!over_crowded_edges || !used.emplace(vertex, t[other]).second)) continue;
                    for (const std::uint32_t next : beside)
                        for (int corner = 0; corner < 3; ++corner)
                            if (mesh.triangles[next][corner] == vertex && groups.group_of[next][corner] == unknown) {
                                groups.group_of[next][corner] = number;
                                open.push_back(next);
                            }
                }
            }
        }
    }
    return groups;
}

/// Calls `use(triangle, neighbour, a, b)` for the neighbours of a triangle, over the edge (a, b).
template <class Use>
void for_each_neighbour(const IndexedMesh& mesh, const EdgeMap& edges, std::uint32_t triangle, Use use)
{
    const glm::uvec3 t = mesh.triangles[triangle];
    for (int k = 0; k < 3; ++k) {
        const auto& beside = edges.at(std::minmax(t[k], t[(k + 1) % 3]));
        if (beside.size() == 2) use(beside[0] == triangle ? beside[1] : beside[0], t[k], t[(k + 1) % 3]);
    }
}

}

ManifoldFaults manifold_faults(const IndexedMesh& mesh)
{
    ManifoldFaults faults;
    for (const auto& [ends, triangles] : triangles_at_edges(mesh))
        if (triangles.size() > 2) faults.crowded_edges.emplace_back(ends.first, ends.second);
    const VertexGroups groups = groups_at_vertices(mesh, true);
    for (std::uint32_t vertex = 0; vertex < groups.counts.size(); ++vertex) {
        if (groups.counts[vertex] == 0) faults.lonely_vertices.push_back(vertex);
        if (groups.counts[vertex] > 1) faults.torn_vertices.push_back(vertex);
    }
    return faults;
}

std::optional<std::vector<glm::uvec3>> coherent_triangles(const IndexedMesh& mesh)
{
    const EdgeMap edges = triangles_at_edges(mesh);
    std::vector<glm::uvec3> result = mesh.triangles;
    std::vector<char> done(result.size(), 0);
    for (std::uint32_t first = 0; first < result.size(); ++first) {
        if (done[first] != 0) continue;
        std::vector<std::uint32_t> open{first};
        done[first] = 1;
        bool possible = true;
        while (!open.empty()) {
            const std::uint32_t triangle = open.back();
            open.pop_back();
            for_each_neighbour(mesh, edges, triangle, [&](std::uint32_t next, std::uint32_t a, std::uint32_t b) {
                const bool agrees = runs_along(result[triangle], a, b) != runs_along(result[next], a, b);
                if (done[next] != 0) {
                    possible = possible && agrees;
                    return;
                }
                if (!agrees) turn(result[next]);
                done[next] = 1;
                open.push_back(next);
            });
        }
        if (!possible) return std::nullopt;
    }
    return result;
}

std::vector<glm::uvec3> outward_triangles(const IndexedMesh& mesh)
{
    const EdgeMap edges = triangles_at_edges(mesh);
    std::vector<glm::uvec3> result = mesh.triangles;
    std::vector<char> done(result.size(), 0);
    for (std::uint32_t first = 0; first < result.size(); ++first) {
        if (done[first] != 0) continue;
        std::vector<std::uint32_t> piece{first};
        done[first] = 1;
        std::size_t sides = 0;
        double volume = 0;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            for_each_neighbour(mesh, edges, piece[i], [&](std::uint32_t next, std::uint32_t, std::uint32_t) {
                ++sides;
                if (done[next] == 0) piece.push_back(next);
                done[next] = 1;
            });
            const glm::uvec3 t = mesh.triangles[piece[i]];
            const glm::dvec3 eye(mesh.positions[mesh.triangles[first].z]);
            volume +=
                determinant(glm::dmat3(glm::dvec3(mesh.positions[t.x]) - eye, glm::dvec3(mesh.positions[t.y]) - eye,
                                       glm::dvec3(mesh.positions[t.z]) - eye));
        }
        if (sides == 3 * piece.size() && volume < 0)
            for (const std::uint32_t triangle : piece) turn(result[triangle]);
    }
    return result;
}

IndexedMesh separated(const IndexedMesh& mesh)
{
    const VertexGroups groups = groups_at_vertices(mesh, false);
    IndexedMesh result = mesh;
    std::vector<std::uint32_t> first_copy(mesh.positions.size(), 0);
    for (std::uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        first_copy[vertex] = static_cast<std::uint32_t>(result.positions.size());
        for (std::uint32_t group = 1; group < groups.counts[vertex]; ++group)
            result.positions.push_back(mesh.positions[vertex]);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k)
            // The last group keeps the vertex.
            if (const std::uint32_t vertex = mesh.triangles[i][k]; groups.group_of[i][k] + 1 < groups.counts[vertex])
                result.triangles[i][k] = first_copy[vertex] + groups.group_of[i][k];
    return result;
}

}
