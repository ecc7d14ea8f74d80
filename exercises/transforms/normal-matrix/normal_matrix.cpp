#include <umbral/transforms/normal_matrix.hpp>

namespace umbral::transforms {

glm::mat3 normal_matrix(const glm::mat4& model)
{
    // TODO: the inverse transpose of the upper left 3 × 3, glm::mat3(model), where there is one. For the hard checks:
    // by the cofactors.
    return not_implemented<glm::mat3>(model);
}

glm::vec3 transformed_normal(const glm::mat4& model, const glm::vec3& normal)
{
    // TODO: the normal matrix times the normal, brought back to length 1. A null vector stays null.
    return not_implemented<glm::vec3>(model, normal);
}

}
