// mistake: transforms normals as any other vector
// credit: 1..20
// hint: Your normals are turned by the model matrix itself. That is right for tangents; under a non-uniform scale or a
// shear a normal does not stay perpendicular to them. Use the inverse transpose.
#include <umbral/transforms/normal_matrix.hpp>

namespace umbral::transforms {

glm::mat3 normal_matrix(const glm::mat4& model) { return glm::mat3(model); }

glm::vec3 transformed_normal(const glm::mat4& model, const glm::vec3& normal)
{
    const glm::dvec3 n = glm::dmat3(glm::mat3(model)) * glm::dvec3(normal);
    return n == glm::dvec3(0) ? glm::vec3(0) : glm::vec3(normalize(n));
}

}
