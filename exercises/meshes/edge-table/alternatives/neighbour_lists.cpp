// alternative: a short list of larger neighbours for each vertex, searched from end to end, as the bounded number of
// edges at a vertex allows
#include <umbral/meshes/edges.hpp>

namespace umbral::meshes {

std::vector<glm::uvec2> edge_table(const IndexedMesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> larger(mesh.positions.size());
    for (const glm::uvec3& t : mesh.triangles) {
        if (t.x == t.y || t.y == t.z || t.z == t.x) continue;
        for (int i = 0; i < 3; ++i) {
            const auto [a, b] = std::minmax(t[i], t[(i + 1) % 3]);
            std::vector<std::uint32_t>& list = larger[a];
            if (std::find(list.begin(), list.end(), b) == list.end()) list.push_back(b);
        }
    }
    std::vector<glm::uvec2> edges;
    for (std::uint32_t a = 0; a < larger.size(); ++a)
        for (const std::uint32_t b : larger[a]) edges.emplace_back(a, b);
    return edges;
}

std::vector<glm::uvec2> edge_table_of_closed(const IndexedMesh& mesh)
{
    std::vector<glm::uvec2> edges;
    for (const glm::uvec3& t : mesh.triangles)
        for (const auto [a, b] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)})
            if (a < b) edges.emplace_back(a, b);
    return edges;
}

}
