// mistake: the inverse transpose in float
// credit: 65..80
// hint: With entries of 1e-20 or 1e20 the determinant is 0 or infinite in float, and a flattened matrix has none to
// divide by. The cofactors need no division: compute them in double.
#include <umbral/transforms/normal_matrix.hpp>

namespace umbral::transforms {

glm::mat3 normal_matrix(const glm::mat4& model) { return glm::transpose(glm::inverse(glm::mat3(model))); }

glm::vec3 transformed_normal(const glm::mat4& model, const glm::vec3& normal)
{
    return normal == glm::vec3(0) ? normal : glm::normalize(normal_matrix(model) * normal);
}

}
