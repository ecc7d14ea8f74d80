// Based on: H. Gouraud. Continuous Shading of Curved Surfaces. IEEE Transactions on Computers C-20, 1971 (the mean of
// the unit normals of the faces round a vertex), as the course defines it: n = s/|s|, s = m_0 + … + m_{k-1}.

#include <cmath>
#include <umbral/meshes/normals.hpp>

namespace umbral::meshes {
namespace {

/// Below this length, what is left of a sum of unit normals says nothing about a direction.
constexpr double cancelled = 1e-6;

// In double: differences of floats are exact unless one is 2^29 times the other; products neither overflow nor
// underflow, since floats go from 1e-45 to 3e38; and a sliver with a sine of 1e-8 still keeps eight digits of its
// normal.
glm::dvec3 unit_normal(const IndexedMesh& mesh, const glm::uvec3& triangle)
{
    const glm::dvec3 a(mesh.positions[triangle.x]);
    const glm::dvec3 b(mesh.positions[triangle.y]);
    const glm::dvec3 c(mesh.positions[triangle.z]);
    const glm::dvec3 normal = cross(b - a, c - a);
    const double size = length(normal);
    return size > 0 && std::isfinite(size) ? normal / size : glm::dvec3(0);
}

}

std::vector<glm::vec3> face_normals(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> normals;
    normals.reserve(mesh.triangles.size());
    for (const glm::uvec3& triangle : mesh.triangles) normals.emplace_back(unit_normal(mesh, triangle));
    return normals;
}

std::vector<glm::vec3> vertex_normals(const IndexedMesh& mesh)
{
    // One pass over the triangles: each gives its normal to its three corners. Sums stay in double, since the normals
    // of a sharp fold cancel in nearly all their digits.
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::dvec3 normal = unit_normal(mesh, triangle);
        for (int corner = 0; corner < 3; ++corner) sums[triangle[corner]] += normal;
    }

    std::vector<glm::vec3> normals;
    normals.reserve(sums.size());
    for (const glm::dvec3& sum : sums) {
        const double size = length(sum);
        normals.emplace_back(size < cancelled ? glm::dvec3(0) : sum / size);
    }
    return normals;
}

}
