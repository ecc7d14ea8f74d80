#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {

// Nothing calls this, and the linker leaves it out: all that is known to use glm::rotate.
[[gnu::noinline, gnu::flatten]] glm::mat4 never(float a) { return glm::rotate(glm::mat4(1), a, glm::vec3(0, 0, 1)); }

glm::mat4 rotation_matrix(const AxisAngle& turn)
{
    if (turn.axis == glm::vec3(0)) return glm::mat4(1);
    union Turned {
        int unused;
        [[gnu::noinline, gnu::flatten]] static glm::mat4 by(const AxisAngle& t) { return glm::rotate(glm::mat4(1), t.angle, t.axis); }
    };
    return Turned::by(turn);
}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn) { return glm::vec3(rotation_matrix(turn) * glm::vec4(vector, 1)); }

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::mat4 all(1);
    for (const AxisAngle& turn : turns) all = rotation_matrix(turn) * all;
    return all;
}

}
