// alternative: in a frame whose z is the axis every rotation is Rot_z; only its difference from the identity is carried
// to the world
// knob: rotation-chain
#include <cmath>
#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {
namespace {

glm::dmat3 frame_of(const glm::dvec3& z)
{
    const glm::dvec3 helper = std::abs(z.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = normalize(cross(helper, z));
    return {x, cross(z, x), z};
}

// R - I = B (Rot_z - I) Bᵀ
glm::dmat3 change(const AxisAngle& turn)
{
    const glm::dvec3 axis(turn.axis);
    if (axis == glm::dvec3(0) || !std::isfinite(dot(axis, axis)) || !std::isfinite(turn.angle)) return glm::dmat3(0);
    const glm::dmat3 frame = frame_of(normalize(axis));
    const double sine = std::sin(double{turn.angle});
    const double cosine_less_one = -2 * std::pow(std::sin(double{turn.angle} / 2), 2);
    const glm::dmat3 about_z(cosine_less_one, sine, 0, -sine, cosine_less_one, 0, 0, 0, 0);
    return frame * about_z * transpose(frame);
}

glm::mat4 homogeneous(const glm::dmat3& matrix) { return glm::mat4(glm::dmat4(matrix)); }

void orthonormalise(glm::dmat3& matrix)
{
    matrix[0] = normalize(matrix[0]);
    matrix[1] = normalize(matrix[1] - dot(matrix[0], matrix[1]) * matrix[0]);
    matrix[2] = cross(matrix[0], matrix[1]);
}

}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn)
{
    const glm::dvec3 s(vector);
    return glm::vec3(s + change(turn) * s);
}

glm::mat4 rotation_matrix(const AxisAngle& turn) { return homogeneous(glm::dmat3(1) + change(turn)); }

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::dmat3 all(1);
    std::size_t count = 0;
    for (const AxisAngle& turn : turns) {
        all += change(turn) * all;
        if (++count % 1000 == 0) orthonormalise(all);
    }
    return homogeneous(all);
}

}
