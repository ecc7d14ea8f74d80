#include <umbral/transforms/basic_matrices.hpp>

namespace umbral::transforms {

// GLM stores columns: m[column][row]. glm::mat4(1) is the identity.

glm::mat4 translation_matrix(const glm::vec3& offset)
{
    // TODO: the identity, with the offset in the last column.
    return not_implemented<glm::mat4>(offset);
}

glm::mat4 scaling_matrix(const glm::vec3& factors)
{
    // TODO: the factors in the diagonal.
    return not_implemented<glm::mat4>(factors);
}

glm::mat4 shear_matrix(int moved, int by, float amount)
{
    // TODO: the identity, with `amount` in the row of the coordinate that changes and the column of the one that it is
    // multiplied with.
    return not_implemented<glm::mat4>(moved, by, amount);
}

glm::mat4 rotation_about_x(float angle)
{
    // TODO: y' = y cosθ - z sinθ, z' = y sinθ + z cosθ.
    return not_implemented<glm::mat4>(angle);
}

glm::mat4 rotation_about_y(float angle)
{
    // TODO: x' = x cosθ + z sinθ, z' = -x sinθ + z cosθ.
    return not_implemented<glm::mat4>(angle);
}

glm::mat4 rotation_about_z(float angle)
{
    // TODO: x' = x cosθ - y sinθ, y' = x sinθ + y cosθ.
    return not_implemented<glm::mat4>(angle);
}

glm::vec3 transform_point(const glm::mat4& matrix, const glm::vec3& point)
{
    // TODO: the matrix times (point, 1).
    return not_implemented<glm::vec3>(matrix, point);
}

glm::vec3 transform_vector(const glm::mat4& matrix, const glm::vec3& vector)
{
    // TODO: the matrix times (vector, 0).
    return not_implemented<glm::vec3>(matrix, vector);
}

glm::mat4 compose_matrices(std::span<const glm::mat4> steps)
{
    // TODO: the product of all of them. Which one stands on the right?
    return not_implemented<glm::mat4>(steps);
}

}
