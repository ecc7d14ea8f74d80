#include <umbral/meshes/weld.hpp>

namespace umbral::meshes {

IndexedMesh weld(const std::vector<glm::vec3>& corners)
{
    // TODO: for each corner, find the vertex that is in its place already, or add one. Three corners make a triangle.
    return not_implemented<IndexedMesh>(corners);
}

std::vector<glm::vec3> isolated_triangles(const IndexedMesh& mesh)
{
    // TODO: the positions of the three corners of each triangle, one after the other.
    return not_implemented<std::vector<glm::vec3>>(mesh);
}

}
