#include <cmath>
#include <umbral/meshes/normals.hpp>

namespace umbral::meshes {
namespace {

std::vector<glm::dvec3> unit_normals(const IndexedMesh& mesh)
{
    std::vector<glm::dvec3> normals(mesh.triangles.size(), glm::dvec3(0));
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const glm::dvec3 c(mesh.positions[t.z]);
        const glm::dvec3 normal = cross(glm::dvec3(mesh.positions[t.x]) - c, glm::dvec3(mesh.positions[t.y]) - c);
        const double square = dot(normal, normal);
        if (square > 0 && square < 1e300) normals[i] = normal / std::sqrt(square);
    }
    return normals;
}

}

std::vector<glm::vec3> face_normals(const IndexedMesh& mesh)
{
    const std::vector<glm::dvec3> normals = unit_normals(mesh);
    return {normals.begin(), normals.end()};
}

std::vector<glm::vec3> vertex_normals(const IndexedMesh& mesh)
{
    const std::vector<glm::dvec3> faces = unit_normals(mesh);
    std::vector<std::size_t> first(mesh.positions.size() + 1, 0);
    for (const glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) ++first[t[corner] + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    std::vector<std::size_t> faces_of(3 * mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner) faces_of[next[mesh.triangles[i][corner]]++] = i;

    std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0));
    for (std::size_t vertex = 0; vertex < normals.size(); ++vertex) {
        glm::dvec3 sum(0);
        for (std::size_t i = first[vertex]; i < first[vertex + 1]; ++i) sum += faces[faces_of[i]];
        if (length(sum) >= 1e-6) normals[vertex] = glm::vec3(normalize(sum));
    }
    return normals;
}

}
