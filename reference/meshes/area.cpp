// Based on: the course's problem 2.6. What double is enough for: N. Higham. Accuracy and Stability of Numerical
// Algorithms, 2nd edition. 2002, chapters 1 and 4.

#include <cmath>
#include <umbral/meshes/area.hpp>

namespace umbral::meshes {
namespace {

// In double: differences of floats have no more than some 30 bits, so their products are exact, or nearly so, and a
// cross product of nearly parallel edges loses nothing when it subtracts them. Squares of lengths of floats' cross
// products lie between 1e-180 and 1e155: nothing over- or underflows.
double area_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const glm::dvec3 origin(a);
    const double area = 0.5 * length(cross(glm::dvec3(b) - origin, glm::dvec3(c) - origin));
    return std::isfinite(area) ? area : 0;
}

}

float triangle_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    return static_cast<float>(area_of(a, b, c));
}

float surface_area(const IndexedMesh& mesh)
{
    // Terms of one sign: n of them lose n/2^53 of their sum at most, a billionth for ten millions.
    double sum = 0;
    for (const glm::uvec3& t : mesh.triangles)
        sum += area_of(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    return static_cast<float>(sum);
}

}
