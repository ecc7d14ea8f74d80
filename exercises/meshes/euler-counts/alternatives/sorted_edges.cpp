// alternative: a sorted list of edges instead of a hash table; pieces and fans by walking from face to face
#include <algorithm>
#include <numeric>
#include <umbral/meshes/euler.hpp>

namespace umbral::meshes {
namespace {

struct HalfEdge {
    std::uint32_t low, high;
    std::uint32_t face;
    std::uint32_t corner;
    bool rises;  // runs from low to high

    bool joins_as(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

std::vector<HalfEdge> sorted_half_edges(const std::vector<glm::uvec3>& triangles)
{
    std::vector<HalfEdge> list;
    for (std::uint32_t face = 0; face < triangles.size(); ++face) {
        const glm::uvec3& t = triangles[face];
        if (t.x == t.y || t.y == t.z || t.z == t.x) continue;
        for (std::uint32_t c = 0; c < 3; ++c) {
            const std::uint32_t a = t[static_cast<int>(c)];
            const std::uint32_t b = t[static_cast<int>((c + 1) % 3)];
            list.push_back({std::min(a, b), std::max(a, b), face, c, a < b});
        }
    }
    std::sort(list.begin(), list.end(),
              [](const HalfEdge& a, const HalfEdge& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
    return list;
}

// How many pieces the marked nodes of a graph fall into.
int count_pieces(const std::vector<std::vector<std::uint32_t>>& neighbours, const std::vector<bool>& marked)
{
    std::vector<bool> seen(neighbours.size(), false);
    int pieces = 0;
    for (std::uint32_t start = 0; start < neighbours.size(); ++start) {
        if (seen[start] || !marked[start]) continue;
        ++pieces;
        std::vector<std::uint32_t> open{start};
        seen[start] = true;
        while (!open.empty()) {
            const std::uint32_t node = open.back();
            open.pop_back();
            for (const std::uint32_t next : neighbours[node])
                if (!seen[next]) seen[next] = true, open.push_back(next);
        }
    }
    return pieces;
}

void join(std::vector<std::vector<std::uint32_t>>& neighbours, std::uint32_t a, std::uint32_t b)
{
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
}

}

TopologyCounts count_topology(const IndexedMesh& mesh)
{
    const std::vector<HalfEdge> list = sorted_half_edges(mesh.triangles);
    const std::size_t size = mesh.positions.size();
    std::vector<std::vector<std::uint32_t>> all(size), rim(size);
    std::vector<bool> used(size, false), on_rim(size, false);
    TopologyCounts counts{};
    counts.faces = static_cast<int>(list.size() / 3);
    for (std::size_t first = 0, last = 0; first < list.size(); first = last) {
        while (last < list.size() && list[last].joins_as(list[first])) ++last;
        const auto [a, b] = std::pair{list[first].low, list[first].high};
        ++counts.edges;
        used[a] = used[b] = true;
        join(all, a, b);
        if (last - first > 2) ++counts.non_manifold_edges;
        if (last - first > 1) continue;
        ++counts.boundary_edges;
        on_rim[a] = on_rim[b] = true;
        join(rim, a, b);
    }
    for (std::size_t i = 0; i < size; ++i) ++(used[i] ? counts.vertices : counts.isolated_vertices);
    counts.components = count_pieces(all, used);
    counts.boundary_loops = count_pieces(rim, on_rim);
    return counts;
}

std::optional<int> genus(const IndexedMesh& mesh)
{
    const std::vector<HalfEdge> list = sorted_half_edges(mesh.triangles);
    if (list.empty()) return std::nullopt;
    std::vector<std::vector<std::uint32_t>> beside(3 * mesh.triangles.size());  // corners next to each other in a fan
    std::vector<bool> is_corner(beside.size(), false);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const HalfEdge& edge = list[i];
        is_corner[3 * edge.face + edge.corner] = true;
        if (i + 1 == list.size() || !edge.joins_as(list[i + 1])) continue;
        const HalfEdge& twin = list[i + 1];
        if (edge.rises == twin.rises || (i + 2 < list.size() && edge.joins_as(list[i + 2]))) return std::nullopt;
        join(beside, 3 * edge.face + edge.corner, 3 * twin.face + (twin.corner + 1) % 3);
        join(beside, 3 * twin.face + twin.corner, 3 * edge.face + (edge.corner + 1) % 3);
    }
    const TopologyCounts n = count_topology(mesh);
    if (count_pieces(beside, is_corner) != n.vertices) return std::nullopt;
    return n.components - (n.vertices - n.edges + n.faces + n.boundary_loops) / 2;
}

std::optional<ElementCounts> sphere_from_faces(std::int64_t faces)
{
    if (faces < 4 || faces % 2 != 0) return std::nullopt;
    return ElementCounts{faces / 2 + 2, faces / 2 * 3, faces};
}

std::optional<ElementCounts> sphere_from_vertices(std::int64_t vertices)
{
    return sphere_from_faces(2 * (vertices - 2));
}

std::optional<ElementCounts> sphere_from_edges(std::int64_t edges)
{
    if (edges % 3 != 0) return std::nullopt;
    return sphere_from_faces(2 * (edges / 3));
}

}
