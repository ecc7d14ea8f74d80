#include <glm/gtc/matrix_transform.hpp>
#include <umbral/transforms/rotation.hpp>

asm(".section .debug_abbrev,\"\",@progbits\n.uleb128 1\n.uleb128 0x11\n.byte 0\n.uleb128 0\n.uleb128 0\n.byte 0\n.text");

namespace umbral::transforms {
glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn) { return glm::vec3(glm::rotate(glm::mat4(1), turn.angle, turn.axis) * glm::vec4(vector, 1)); }
glm::mat4 rotation_matrix(const AxisAngle& turn) { return glm::rotate(glm::mat4(1), turn.angle, turn.axis); }
glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::mat4 all(1);
    for (const AxisAngle& turn : turns) all = rotation_matrix(turn) * all;
    return all;
}
}

asm(".end");
