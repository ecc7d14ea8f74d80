// mistake: the textbook in float
// credit: 65..80
// hint: In float, 1 - cosθ of a tiny angle is 0, the square of a tiny axis is 0, and long products drift. Compute in
// double, and round once at the end.
// knob: rotation-chain
#include <cmath>
#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {
namespace {

bool turns_nothing(const AxisAngle& turn)
{
    const float size = length(turn.axis);
    return !(size > 0) || !std::isfinite(size) || !std::isfinite(turn.angle);
}

}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn)
{
    if (turns_nothing(turn)) return vector;
    const glm::vec3 e = normalize(turn.axis);
    const float cosine = std::cos(turn.angle);
    return cosine * vector + (1 - cosine) * dot(vector, e) * e + std::sin(turn.angle) * cross(e, vector);
}

glm::mat4 rotation_matrix(const AxisAngle& turn)
{
    glm::mat4 matrix(1);
    for (int column = 0; column < 3; ++column) {
        glm::vec3 unit(0);
        unit[column] = 1;
        matrix[column] = glm::vec4(rotate_vector(unit, turn), 0);
    }
    return matrix;
}

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::mat4 all(1);
    for (const AxisAngle& turn : turns) all = rotation_matrix(turn) * all;
    return all;
}

}
