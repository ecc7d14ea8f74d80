#include <umbral/meshes/edges.hpp>

namespace umbral::meshes {

std::vector<glm::uvec2> edge_table(const IndexedMesh& mesh)
{
    // TODO: each pair of vertices that follow each other round a triangle, once. Two triangles may run along an edge in
    // the same direction or in opposite ones, and an edge may have one triangle only.
    return not_implemented<std::vector<glm::uvec2>>(mesh);
}

std::vector<glm::uvec2> edge_table_of_closed(const IndexedMesh& mesh)
{
    // TODO: here every edge is run along exactly twice, once from a to b and once from b to a. Which of the two do you
    // keep?
    return not_implemented<std::vector<glm::uvec2>>(mesh);
}

}
