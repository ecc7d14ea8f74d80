// Based on: L. Euler. Elementa doctrinae solidorum. 1758 (V - E + F = 2); for surfaces with handles and rims: H.
// Edelsbrunner, J. Harer. Computational Topology. 2010, chapter II. Pieces by disjoint sets: R. Tarjan. Efficiency of a
// Good But Not Linear Set Union Algorithm. 1975.

#include <algorithm>
#include <numeric>
#include <umbral/meshes/euler.hpp>
#include <unordered_map>

namespace umbral::meshes {
namespace {

/// A pair of vertices as one number; 64 bits, since the product of two numbers of vertices does not fit into 32.
std::uint64_t key_of(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32U | to; }

bool is_face(const glm::uvec3& t) { return t.x != t.y && t.y != t.z && t.z != t.x; }

class DisjointSets {
public:
    explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

    /// Makes one set of the two; true if they were two.
    bool unite(std::size_t a, std::size_t b)
    {
        const std::size_t root_a = root(a);
        const std::size_t root_b = root(b);
        parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
        return root_a != root_b;
    }

private:
    std::size_t root(std::size_t a)
    {
        while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
        return a;
    }

    std::vector<std::size_t> parent_;
};

}

TopologyCounts count_topology(const IndexedMesh& mesh)
{
    TopologyCounts counts{};
    std::unordered_map<std::uint64_t, int> faces_at;
    std::vector<bool> is_used(mesh.positions.size(), false);
    for (const glm::uvec3& t : mesh.triangles) {
        if (!is_face(t)) continue;
        ++counts.faces;
        for (int corner = 0; corner < 3; ++corner) {
            const auto [a, b] = std::minmax(t[corner], t[(corner + 1) % 3]);
            ++faces_at[key_of(a, b)];
            is_used[a] = true;
        }
    }
    counts.edges = static_cast<int>(faces_at.size());

    // Each edge that joins two pieces makes them one: there are as many pieces as vertices less such edges.
    DisjointSets pieces(mesh.positions.size());
    DisjointSets rims(mesh.positions.size());
    std::vector<bool> is_on_rim(mesh.positions.size(), false);
    for (const auto& [edge, faces] : faces_at) {
        const auto a = static_cast<std::uint32_t>(edge >> 32U);
        const auto b = static_cast<std::uint32_t>(edge);
        is_used[b] = true;
        if (pieces.unite(a, b)) --counts.components;
        if (faces > 2) ++counts.non_manifold_edges;
        if (faces > 1) continue;
        ++counts.boundary_edges;
        is_on_rim[a] = is_on_rim[b] = true;
        if (rims.unite(a, b)) --counts.boundary_loops;
    }
    counts.vertices = static_cast<int>(std::count(is_used.begin(), is_used.end(), true));
    counts.isolated_vertices = static_cast<int>(mesh.positions.size()) - counts.vertices;
    counts.components += counts.vertices;
    counts.boundary_loops += static_cast<int>(std::count(is_on_rim.begin(), is_on_rim.end(), true));
    return counts;
}

std::optional<int> genus(const IndexedMesh& mesh)
{
    // Where the winding is coherent and no edge has three faces, no edge is run along twice in one direction.
    std::unordered_map<std::uint64_t, std::size_t>
        corner_at;  // the corner (3 times the triangle's place + 0, 1, 2) from which an edge is run along
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (int corner = 0; corner < 3 && is_face(mesh.triangles[i]); ++corner)
            if (!corner_at
                     .try_emplace(key_of(mesh.triangles[i][corner], mesh.triangles[i][(corner + 1) % 3]),
                                  3 * i + static_cast<std::size_t>(corner))
                     .second)
                return std::nullopt;
    if (corner_at.empty()) return std::nullopt;

    // The corners at a vertex hang together over edges: where every vertex has one such fan, there are as many fans as
    // vertices.
    DisjointSets fans(3 * mesh.triangles.size());
    auto fan_count = static_cast<int>(corner_at.size());
    for (const auto& [edge, corner] : corner_at) {
        const auto twin = corner_at.find(edge << 32U | edge >> 32U);
        if (twin == corner_at.end()) continue;
        const std::size_t start = twin->second / 3 * 3;
        if (fans.unite(corner, start + (twin->second - start + 1) % 3)) --fan_count;
    }
    const TopologyCounts counts = count_topology(mesh);
    if (fan_count != counts.vertices) return std::nullopt;

    return (2 * counts.components - counts.boundary_loops - (counts.vertices - counts.edges + counts.faces)) / 2;
}

std::optional<ElementCounts> sphere_from_vertices(std::int64_t vertices)
{
    if (vertices < 4) return std::nullopt;
    return ElementCounts{vertices, 3 * (vertices - 2), 2 * (vertices - 2)};
}

std::optional<ElementCounts> sphere_from_edges(std::int64_t edges)
{
    return edges % 3 == 0 ? sphere_from_vertices(edges / 3 + 2) : std::nullopt;
}
std::optional<ElementCounts> sphere_from_faces(std::int64_t faces)
{
    return faces % 2 == 0 ? sphere_from_vertices(faces / 2 + 2) : std::nullopt;
}

}
