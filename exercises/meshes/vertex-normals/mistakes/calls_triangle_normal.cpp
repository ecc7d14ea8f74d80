// mistake: calls GLM's own function
// credit: 0..0
// verdict: forbidden
// hint: glm::triangleNormal is what you write here.
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/normal.hpp>
#include <umbral/meshes/normals.hpp>

namespace umbral::meshes {

std::vector<glm::vec3> face_normals(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> normals;
    for (const glm::uvec3& t : mesh.triangles)
        normals.push_back(glm::triangleNormal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]));
    return normals;
}

std::vector<glm::vec3> vertex_normals(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0));
    const std::vector<glm::vec3> faces = face_normals(mesh);
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (int corner = 0; corner < 3; ++corner) normals[mesh.triangles[i][corner]] += faces[i];
    for (glm::vec3& normal : normals)
        if (length(normal) >= 1e-6F) normal = normalize(normal);
    return normals;
}

}
