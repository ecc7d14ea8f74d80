#include <umbral/meshes/area.hpp>

namespace umbral::meshes {

float triangle_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    // TODO: half the length of the cross product of two edges; 0 if a corner is not finite.
    return not_implemented<float>(a, b, c);
}

float surface_area(const IndexedMesh& mesh)
{
    // TODO: the sum over all triangles. How many digits does the sum keep?
    return not_implemented<float>(mesh);
}

}
