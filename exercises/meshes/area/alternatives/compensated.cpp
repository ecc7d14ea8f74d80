// alternative: only the cross product is in double; the sum is in float, and keeps what each addition loses (Kahan)
// knob: summation
#include <umbral/meshes/area.hpp>

namespace umbral::meshes {

float triangle_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const glm::dvec3 d(c);
    const glm::dvec3 m = cross(glm::dvec3(a) - d, glm::dvec3(b) - d);
    const double square = dot(m, m);
    return square < 1e300 ? static_cast<float>(std::sqrt(square) / 2) : 0;
}

float surface_area(const IndexedMesh& mesh)
{
    float sum = 0;
    float lost = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const float term = triangle_area(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]) - lost;
        const float next = sum + term;
        lost = (next - sum) - term;
        sum = next;
    }
    return sum;
}

}
