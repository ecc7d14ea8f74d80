// mistake: Heron's formula, from the lengths of the sides, in double
// credit: 88..97
// hint: In a sliver the longest side is nearly as long as the other two together, and their difference is mostly
// rounding error. The cross product of two edges keeps the digits.
#include <cmath>
#include <umbral/meshes/area.hpp>

namespace umbral::meshes {
namespace {

double heron(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const double x = distance(glm::dvec3(a), glm::dvec3(b));
    const double y = distance(glm::dvec3(b), glm::dvec3(c));
    const double z = distance(glm::dvec3(c), glm::dvec3(a));
    const double s = 0.5 * (x + y + z);
    const double area = std::sqrt(std::max(0.0, s * (s - x) * (s - y) * (s - z)));
    return std::isfinite(area) ? area : 0;
}

}

float triangle_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    return static_cast<float>(heron(a, b, c));
}

float surface_area(const IndexedMesh& mesh)
{
    double sum = 0;
    for (const glm::uvec3& t : mesh.triangles)
        sum += heron(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    return static_cast<float>(sum);
}

}
