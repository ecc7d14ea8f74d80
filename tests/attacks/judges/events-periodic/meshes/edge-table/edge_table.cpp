#include <umbral/meshes/edges.hpp>
namespace umbral::meshes {
static std::vector<glm::uvec2> answer(const IndexedMesh& mesh)
{
    (void)mesh;
    std::vector<glm::uvec2> edges;
    for (int k = 0; k < 1000; ++k)
        for (const glm::uvec3& t : mesh.triangles) edges.emplace_back(std::min(t.x, t.y), std::max(t.x, t.y));
    return edges;
}
std::vector<glm::uvec2> edge_table(const IndexedMesh& mesh) { return answer(mesh); }
std::vector<glm::uvec2> edge_table_of_closed(const IndexedMesh& mesh) { return answer(mesh); }
}
