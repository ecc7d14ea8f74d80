#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/rotate_vector.hpp>
#include <glm/gtx/transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/quaternion.hpp>
#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {

glm::mat4 rotation_matrix(const AxisAngle& turn)
{
    if (turn.axis == glm::vec3(0)) return glm::mat4(1);
    const glm::vec3 e = glm::normalize(turn.axis);
    const float c = std::cos(turn.angle);
    return glm::mat4(glm::mat3(c) + (1 - c) * glm::outerProduct(e, e) + std::sin(turn.angle) * glm::mat3(0, e.z, -e.y, -e.z, 0, e.x, e.y, -e.x, 0));
}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn) { return glm::vec3(rotation_matrix(turn) * glm::vec4(vector, 1)); }

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::mat4 all(1);
    for (const AxisAngle& turn : turns) all = rotation_matrix(turn) * all;
    return all;
}

}
