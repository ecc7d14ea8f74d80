// alternative: sums halves of the mesh first, and those of their halves, so that numbers of one size are added
// knob: summation
#include <umbral/meshes/area.hpp>

namespace umbral::meshes {
namespace {

double twice_the_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const glm::dvec3 u = glm::dvec3(b) - glm::dvec3(a);
    const glm::dvec3 v = glm::dvec3(c) - glm::dvec3(b);
    const double size = std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    return std::isnan(size) || std::isinf(size) ? 0 : size;
}

double sum_of(const IndexedMesh& mesh, std::size_t begin, std::size_t end)
{
    if (begin == end) return 0;
    if (end - begin > 1) return sum_of(mesh, begin, (begin + end) / 2) + sum_of(mesh, (begin + end) / 2, end);
    const glm::uvec3& t = mesh.triangles[begin];
    return twice_the_area(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
}

}

float triangle_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    return static_cast<float>(twice_the_area(a, b, c) / 2);
}

float surface_area(const IndexedMesh& mesh) { return static_cast<float>(sum_of(mesh, 0, mesh.triangles.size()) / 2); }

}
