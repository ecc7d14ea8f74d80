// Based on: the course's definition of 2-manifolds; J. O'Rourke. Computational Geometry in C. 1998 (volume as a sum of
// signed tetrahedra); B. A. Galler, M. J. Fisher. An Improved Equivalence Algorithm. Communications of the ACM 7, 1964
// (groups as trees).

#include <algorithm>
#include <numeric>
#include <umbral/meshes/orientation.hpp>

namespace umbral::meshes {
namespace {

/// Sets that grow together.
class Groups {
public:
    explicit Groups(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }

    std::size_t find(std::size_t item)
    {
        while (parents_[item] != item) item = parents_[item] = parents_[parents_[item]];
        return item;
    }

    /// The smaller item stands for the group.
    void join(std::size_t a, std::size_t b)
    {
        a = find(a);
        b = find(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parents_;
};

/// One triangle's way along an edge: from its corner `from` to its corner `to`. Corners are counted through: 3 triangle
/// + place.
struct Side {
    std::uint32_t low, high;
    std::size_t from, to;

    [[nodiscard]] std::size_t triangle() const { return from / 3; }
    [[nodiscard]] bool is_same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

/// Calls `use` with all sides of an edge, for each edge in sorted order.
template <class Use>
void for_each_edge(const IndexedMesh& mesh, Use use)
{
    std::vector<Side> sides;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[i][k];
            const std::uint32_t b = mesh.triangles[i][(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), 3 * i + static_cast<std::size_t>(k),
                             3 * i + static_cast<std::size_t>((k + 1) % 3)});
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
    for (auto first = sides.begin(); first != sides.end();) {
        const auto last =
            std::find_if(first, sides.end(), [&](const Side& side) { return !side.is_same_edge(*first); });
        use(std::vector<Side>(first, last));
        first = last;
    }
}

std::uint32_t vertex_at(const IndexedMesh& mesh, std::size_t corner)
{
    return mesh.triangles[corner / 3][static_cast<int>(corner % 3)];
}

/// Joins the corners of two triangles at the ends of the edge that they share.
void join_ends(Groups& corners, const IndexedMesh& mesh, const Side& a, const Side& b)
{
    const bool same_way = vertex_at(mesh, a.from) == vertex_at(mesh, b.from);
    corners.join(a.from, same_way ? b.from : b.to);
    corners.join(a.to, same_way ? b.to : b.from);
}

glm::uvec3 turned_over(const glm::uvec3& t) { return {t.x, t.z, t.y}; }

}

ManifoldFaults manifold_faults(const IndexedMesh& mesh)
{
    ManifoldFaults faults;
    Groups corners(3 * mesh.triangles.size());
    for_each_edge(mesh, [&](const std::vector<Side>& sides) {
        if (sides.size() > 2) faults.crowded_edges.emplace_back(sides[0].low, sides[0].high);
        for (std::size_t i = 1; i < sides.size(); ++i) join_ends(corners, mesh, sides[0], sides[i]);
    });
    std::vector<int> groups(mesh.positions.size(), 0);
    for (std::size_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner)
        if (corners.find(corner) == corner) ++groups[vertex_at(mesh, corner)];
    for (std::uint32_t vertex = 0; vertex < groups.size(); ++vertex) {
        if (groups[vertex] == 0) faults.lonely_vertices.push_back(vertex);
        if (groups[vertex] > 1) faults.torn_vertices.push_back(vertex);
    }
    return faults;
}

std::optional<std::vector<glm::uvec3>> coherent_triangles(const IndexedMesh& mesh)
{
    // Each triangle is two items: as it is (2i), and turned over (2i + 1). Neighbours that agree join like with like,
    // others crosswise.
    const std::size_t count = mesh.triangles.size();
    Groups windings(2 * count);
    for_each_edge(mesh, [&](const std::vector<Side>& sides) {
        if (sides.size() != 2) return;
        const std::size_t a = 2 * sides[0].triangle();
        const std::size_t b = 2 * sides[1].triangle();
        const std::size_t crosswise = vertex_at(mesh, sides[0].from) == vertex_at(mesh, sides[1].from) ? 1 : 0;
        windings.join(a, b + crosswise);
        windings.join(a + 1, b + 1 - crosswise);
    });
    std::vector<glm::uvec3> triangles = mesh.triangles;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t group = windings.find(2 * i);
        if (group == windings.find(2 * i + 1)) return std::nullopt;
        // The group's first item is the first triangle of the piece, as it is or turned over.
        if (group % 2 == 1) triangles[i] = turned_over(triangles[i]);
    }
    return triangles;
}

std::vector<glm::uvec3> outward_triangles(const IndexedMesh& mesh)
{
    const std::size_t count = mesh.triangles.size();
    Groups pieces(count);
    std::vector<int> neighbours(count, 0);
    for_each_edge(mesh, [&](const std::vector<Side>& sides) {
        if (sides.size() != 2) return;
        pieces.join(sides[0].triangle(), sides[1].triangle());
        for (const Side& side : sides) ++neighbours[side.triangle()];
    });
    // Seen from a vertex of the piece itself, corners are near: differences of floats are exact in double, and nothing
    // large cancels.
    std::vector<double> volumes(count, 0);
    std::vector<char> is_open(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t piece = pieces.find(i);
        const glm::dvec3 origin(mesh.positions[mesh.triangles[piece].x]);
        const auto corner = [&](int k) { return glm::dvec3(mesh.positions[mesh.triangles[i][k]]) - origin; };
        volumes[piece] += dot(corner(0), cross(corner(1), corner(2)));
        if (neighbours[i] < 3) is_open[piece] = 1;
    }
    std::vector<glm::uvec3> triangles = mesh.triangles;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t piece = pieces.find(i);
        if (is_open[piece] == 0 && volumes[piece] < 0) triangles[i] = turned_over(triangles[i]);
    }
    return triangles;
}

IndexedMesh separated(const IndexedMesh& mesh)
{
    // Only edges of two triangles hold a group together. So a group at a vertex is a fan or a ring; of an edge's
    // triangles it holds two at most, and all edges become regular.
    Groups corners(3 * mesh.triangles.size());
    for_each_edge(mesh, [&](const std::vector<Side>& sides) {
        if (sides.size() == 2) join_ends(corners, mesh, sides[0], sides[1]);
    });
    IndexedMesh result = mesh;
    std::vector<char> is_taken(mesh.positions.size(), 0);
    for (std::size_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
        const std::size_t first = corners.find(corner);
        std::uint32_t& vertex = result.triangles[corner / 3][static_cast<int>(corner % 3)];
        if (first != corner) {
            vertex = vertex_at(result, first);
        } else if (is_taken[vertex] == 0) {
            is_taken[vertex] = 1;
        } else {
            result.positions.push_back(mesh.positions[vertex]);
            vertex = static_cast<std::uint32_t>(result.positions.size() - 1);
        }
    }
    return result;
}

}
