#include <cmath>
#include <umbral/meshes/normals.hpp>

#include "wide_vector.hpp"

// The definition with 113 bits, rounded to float once: sums, products and normals alike. Each vertex collects the
// normals of its triangles from a list, instead of triangles giving theirs away: another way to the same sums.

namespace umbral::meshes {
namespace {

bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

WideVector unit_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    if (!finite(a) || !finite(b) || !finite(c)) return {0, 0, 0};
    const WideVector normal = cross(widened(b) - widened(a), widened(c) - widened(a));
    const Wide size = length(normal);
    return size > 0 ? normal / size : WideVector{0, 0, 0};
}

std::vector<WideVector> wide_normals(const IndexedMesh& mesh)
{
    std::vector<WideVector> normals;
    for (const glm::uvec3& t : mesh.triangles)
        normals.push_back(unit_normal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]));
    return normals;
}

}

std::vector<glm::vec3> face_normals(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> normals;
    for (const WideVector& normal : wide_normals(mesh)) normals.push_back(rounded(normal));
    return normals;
}

std::vector<glm::vec3> vertex_normals(const IndexedMesh& mesh)
{
    const std::vector<WideVector> faces = wide_normals(mesh);
    std::vector<std::vector<std::size_t>> faces_of(mesh.positions.size());
    for (std::size_t face = 0; face < faces.size(); ++face)
        for (int corner = 0; corner < 3; ++corner) faces_of[mesh.triangles[face][corner]].push_back(face);

    std::vector<glm::vec3> normals;
    for (const std::vector<std::size_t>& adjacent : faces_of) {
        WideVector sum{0, 0, 0};
        for (const std::size_t face : adjacent) sum = sum + faces[face];
        const Wide size = length(sum);
        normals.push_back(size < Wide(1e-6) ? glm::vec3(0) : rounded(sum / size));
    }
    return normals;
}

}
