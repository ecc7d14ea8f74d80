// alternative: the edges are made unit first, so that nothing can overflow; a sine under 1e-12 counts as a straight
// line
#include <cmath>
#include <umbral/meshes/normals.hpp>

namespace umbral::meshes {
namespace {

glm::dvec3 unit(const glm::dvec3& v)
{
    const double size = std::hypot(v.x, v.y, v.z);
    return size > 0 && std::isfinite(size) ? v / size : glm::dvec3(0);
}

glm::dvec3 normal_of(const IndexedMesh& mesh, const glm::uvec3& t)
{
    const glm::dvec3 corner[3] = {glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]),
                                  glm::dvec3(mesh.positions[t.z])};
    const glm::dvec3 normal = cross(unit(corner[1] - corner[0]), unit(corner[2] - corner[0]));
    return length(normal) > 1e-12 ? unit(normal) : glm::dvec3(0);
}

}

std::vector<glm::vec3> face_normals(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> normals;
    for (const glm::uvec3& t : mesh.triangles) normals.emplace_back(normal_of(mesh, t));
    return normals;
}

std::vector<glm::vec3> vertex_normals(const IndexedMesh& mesh)
{
    std::vector<glm::dvec3> sums(mesh.positions.size());
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 normal = normal_of(mesh, t);
        sums[t.x] += normal;
        sums[t.y] += normal;
        sums[t.z] += normal;
    }
    std::vector<glm::vec3> normals;
    for (const glm::dvec3& sum : sums) normals.emplace_back(length(sum) < 1e-6 ? glm::dvec3(0) : unit(sum));
    return normals;
}

}
