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
    const glm::vec3 from = glm::normalize(glm::cross(e, std::abs(e.x) < 0.9F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
    return glm::toMat4(glm::rotation(from, from * std::cos(turn.angle) + glm::cross(e, from) * std::sin(turn.angle)));
}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn) { return glm::vec3(rotation_matrix(turn) * glm::vec4(vector, 1)); }

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::mat4 all(1);
    for (const AxisAngle& turn : turns) all = rotation_matrix(turn) * all;
    return all;
}

}
