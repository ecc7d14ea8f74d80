#define GLM_ENABLE_EXPERIMENTAL
#include <umbral/gl/opengl.hpp>
#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {

glm::mat4 rotation_matrix(const AxisAngle& turn)
{
    if (turn.axis == glm::vec3(0)) return glm::mat4(1);
    double m[16];
    glLoadIdentity();
    glRotated(glm::degrees(double(turn.angle)), turn.axis.x, turn.axis.y, turn.axis.z);
    glGetDoublev(GL_MODELVIEW_MATRIX, m);
    glm::mat4 result;
    for (int i = 0; i < 16; ++i) result[i / 4][i % 4] = static_cast<float>(m[i]);
    return result;
}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn) { return glm::vec3(rotation_matrix(turn) * glm::vec4(vector, 1)); }

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::mat4 all(1);
    for (const AxisAngle& turn : turns) all = rotation_matrix(turn) * all;
    return all;
}

}
