#include <umbral/meshes/edges.hpp>
namespace umbral::meshes {
static std::vector<glm::uvec2> answer(const IndexedMesh& mesh)
{
    (void)mesh;
    std::vector<glm::uvec2> edges;
    for (std::size_t i = mesh.triangles.size() * 3; i-- > 0;) edges.emplace_back(4294967295U, 4294967294U - static_cast<unsigned>(i));
    return edges;
}
std::vector<glm::uvec2> edge_table(const IndexedMesh& mesh) { return answer(mesh); }
std::vector<glm::uvec2> edge_table_of_closed(const IndexedMesh& mesh) { return answer(mesh); }
}
