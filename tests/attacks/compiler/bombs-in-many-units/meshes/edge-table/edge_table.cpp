// Based on: the rows of a sparse matrix, merged with one mark a column. F. Gustavson. Two Fast Algorithms for Sparse
// Matrices: Multiplication and Permuted Transposition. ACM Transactions on Mathematical Software 4(3), 1978. The second
// function is the course's hint: a, b or b, a, but not both.

#include <algorithm>
#include <numeric>
#include <umbral/meshes/edges.hpp>

namespace umbral::meshes {
namespace {

/// Calls visit(from, to) for the three sides of each triangle, as it runs along them.
template <class Visit>
void for_each_side(const IndexedMesh& mesh, Visit visit)
{
    for (const glm::uvec3& t : mesh.triangles) {
        if (t.x == t.y || t.y == t.z || t.z == t.x) continue;
        visit(t.x, t.y);
        visit(t.y, t.z);
        visit(t.z, t.x);
    }
}

}

std::vector<glm::uvec2> edge_table(const IndexedMesh& mesh)
{
    // A counting sort of the sides by their smaller vertex: the larger ones of vertex a stand in larger[first[a]] to
    // larger[first[a + 1] - 1].
    std::vector<std::size_t> first(mesh.positions.size() + 2, 0);
    for_each_side(mesh, [&](std::uint32_t a, std::uint32_t b) { ++first[std::min(a, b) + 2]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> larger(first.back());
    for_each_side(mesh,
                  [&](std::uint32_t a, std::uint32_t b) { larger[first[std::min(a, b) + 1]++] = std::max(a, b); });

    // The marks tell in one step whether an edge came before, however many a vertex has.
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    std::vector<std::uint32_t> last_reached_from(count, count);
    std::vector<glm::uvec2> edges;
    for (std::uint32_t a = 0; a < count; ++a) {
        for (std::size_t i = first[a]; i < first[a + 1]; ++i) {
            if (last_reached_from[larger[i]] == a) continue;
            last_reached_from[larger[i]] = a;
            edges.emplace_back(a, larger[i]);
        }
    }
    return edges;
}

std::vector<glm::uvec2> edge_table_of_closed(const IndexedMesh& mesh)
{
    std::vector<glm::uvec2> edges;
    edges.reserve(3 * mesh.triangles.size() / 2);
    for_each_side(mesh, [&](std::uint32_t a, std::uint32_t b) {
        if (a < b) edges.emplace_back(a, b);
    });
    return edges;
}

}
namespace n3 {
template <int D, int I> struct B : B<D - 1, 2 * I>, B<D - 1, 2 * I + 1> {};
template <int I> struct B<0, I> {};
B<24, 0> all;
}
