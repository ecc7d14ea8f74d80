// mistake: the textbook in float
// credit: 78..90
// hint: In float the cross product of nearly parallel edges is mostly rounding error, and the length of a cross product
// leaves float's range for edges under 1e-11 or over 1e9. Make glm::dvec3 of the corners first.
#include <umbral/meshes/normals.hpp>

namespace umbral::meshes {
namespace {

glm::vec3 unit_or_zero(const glm::vec3& v, float smallest)
{
    const float size = length(v);
    return size > smallest && std::isfinite(size) ? v / size : glm::vec3(0);
}

glm::vec3 unit_normal(const IndexedMesh& mesh, const glm::uvec3& t)
{
    const glm::vec3& a = mesh.positions[t.x];
    return unit_or_zero(cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a), 0);
}

}

std::vector<glm::vec3> face_normals(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> normals;
    for (const glm::uvec3& t : mesh.triangles) normals.push_back(unit_normal(mesh, t));
    return normals;
}

std::vector<glm::vec3> vertex_normals(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0));
    for (const glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) normals[t[corner]] += unit_normal(mesh, t);
    for (glm::vec3& normal : normals) normal = unit_or_zero(normal, 1e-6F);
    return normals;
}

}
