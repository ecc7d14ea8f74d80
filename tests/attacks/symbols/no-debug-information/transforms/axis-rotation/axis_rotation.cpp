#pragma GCC optimize("g0")
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/transforms/rotation.hpp>
namespace umbral::transforms {
__attribute__((optimize("O3", "g0"))) glm::mat4 rotation_matrix(const AxisAngle& turn) { return glm::rotate(glm::mat4(1), turn.angle, turn.axis); }
glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn) { return glm::vec3(rotation_matrix(turn) * glm::vec4(vector, 1)); }
glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::mat4 all(1);
    for (const AxisAngle& turn : turns) all = rotation_matrix(turn) * all;
    return all;
}
}
