// mistake: calls the function that it should write
// credit: 0..0
// hint: glm::rotate is what you are asked to write. Start with a unit vector along the axis.
// verdict: forbidden
#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn)
{
    return glm::vec3(rotation_matrix(turn) * glm::vec4(vector, 0));
}

glm::mat4 rotation_matrix(const AxisAngle& turn)
{
    return turn.axis == glm::vec3(0) ? glm::mat4(1) : glm::rotate(glm::mat4(1), turn.angle, turn.axis);
}

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::mat4 all(1);
    for (const AxisAngle& turn : turns) all = rotation_matrix(turn) * all;
    return all;
}

}
