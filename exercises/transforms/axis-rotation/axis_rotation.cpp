#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn)
{
    // TODO: make a unit vector e of the axis, and use Rodrigues' formula: cosθ s + (1 - cosθ)(s·e) e + sinθ e × s.
    return not_implemented<glm::vec3>(vector, turn);
}

glm::mat4 rotation_matrix(const AxisAngle& turn)
{
    // TODO: the columns are what becomes of (1,0,0), (0,1,0) and (0,0,1); the last one is (0,0,0,1). matrix[2][0] is in
    // row 0, column 2.
    return not_implemented<glm::mat4>(turn);
}

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    // TODO: the product of all matrices, the first turn on the right. There may be millions of turns: do not round
    // after each.
    return not_implemented<glm::mat4>(turns);
}

}
