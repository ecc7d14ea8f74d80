// alternative: Rodrigues' formula as the course writes it, and products of matrices, all in double
// knob: rotation-chain
#include <cmath>
#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {
namespace {

struct Prepared {
    glm::dvec3 e{0};
    double sine = 0;
    double versine = 0;  // 1 - cos
};

Prepared prepare(const AxisAngle& turn)
{
    const glm::dvec3 axis(turn.axis);
    const double size = length(axis);
    if (!(size > 0) || !std::isfinite(size) || !std::isfinite(turn.angle)) return {};
    const double angle = turn.angle;
    const double half = std::sin(angle / 2);
    return {axis / size, std::sin(angle), 2 * half * half};
}

glm::dmat3 matrix_of(const AxisAngle& turn)
{
    const auto [e, sine, versine] = prepare(turn);
    glm::dmat3 m;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) m[column][row] = versine * e[row] * e[column];
    for (int i = 0; i < 3; ++i) m[i][i] = 1 - versine * (1 - e[i] * e[i]);
    m[0][1] += sine * e.z;
    m[1][0] -= sine * e.z;
    m[1][2] += sine * e.x;
    m[2][1] -= sine * e.x;
    m[2][0] += sine * e.y;
    m[0][2] -= sine * e.y;
    return m;
}

}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn)
{
    const auto [e, sine, versine] = prepare(turn);
    const glm::dvec3 s(vector);
    return glm::vec3(s + sine * cross(e, s) + versine * (dot(s, e) * e - s));
}

glm::mat4 rotation_matrix(const AxisAngle& turn) { return glm::mat4(glm::mat3(matrix_of(turn))); }

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::dmat3 all(1);
    for (const AxisAngle& turn : turns) all = matrix_of(turn) * all;
    return glm::mat4(glm::mat3(all));
}

}
