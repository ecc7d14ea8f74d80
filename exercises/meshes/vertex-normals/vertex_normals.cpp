#include <umbral/meshes/normals.hpp>

namespace umbral::meshes {

std::vector<glm::vec3> face_normals(const IndexedMesh& mesh)
{
    // TODO: for each triangle, the cross product of two of its edges, divided by its length.
    // A degenerate triangle has a cross product of length 0: its normal is the zero vector.
    return not_implemented<std::vector<glm::vec3>>(mesh);
}

std::vector<glm::vec3> vertex_normals(const IndexedMesh& mesh)
{
    // TODO: for each vertex, the sum of the unit normals of its triangles, divided by the length of the sum.
    // Go over the triangles once. A sum shorter than 1e-6 gives the zero vector.
    return not_implemented<std::vector<glm::vec3>>(mesh);
}

}
