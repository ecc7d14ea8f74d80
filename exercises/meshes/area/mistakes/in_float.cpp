// mistake: computes and adds in float throughout
// credit: 55..82
// hint: Your formula is right, but float has seven digits: a thin triangle loses them in the cross product, a million
// triangles lose them in the sum. Compute in double, and round once.
// knob: summation
#include <cmath>
#include <umbral/meshes/area.hpp>

namespace umbral::meshes {

float triangle_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const float area = 0.5F * length(cross(b - a, c - a));
    return std::isfinite(area) ? area : 0;
}

float surface_area(const IndexedMesh& mesh)
{
    float sum = 0;
    for (const glm::uvec3& t : mesh.triangles)
        sum += triangle_area(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    return sum;
}

}
