// alternative: a hash table of the edges met so far; for closed meshes the other direction, from the larger vertex to
// the smaller
#include <umbral/meshes/edges.hpp>
#include <unordered_set>

namespace umbral::meshes {

std::vector<glm::uvec2> edge_table(const IndexedMesh& mesh)
{
    std::vector<glm::uvec2> edges;
    std::unordered_set<std::uint64_t> met;
    for (const glm::uvec3& t : mesh.triangles) {
        if (t.x == t.y || t.y == t.z || t.z == t.x) continue;
        for (int i = 0; i < 3; ++i) {
            const std::uint64_t low = std::min(t[i], t[(i + 1) % 3]);
            const std::uint64_t high = std::max(t[i], t[(i + 1) % 3]);
            if (met.insert(low << 32U | high).second) edges.emplace_back(t[i], t[(i + 1) % 3]);
        }
    }
    return edges;
}

std::vector<glm::uvec2> edge_table_of_closed(const IndexedMesh& mesh)
{
    std::vector<glm::uvec2> edges;
    for (const glm::uvec3& t : mesh.triangles)
        for (int i = 2; i >= 0; --i)
            if (t[i] > t[(i + 1) % 3]) edges.emplace_back(t[i], t[(i + 1) % 3]);
    return edges;
}

}
