#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtc/matrix_transform.hpp>
#define rotate turned
#define rotate_slow turned_slow
#define translate moved
#define scale sized
#define scale_slow sized_slow
#define identity identical
#define lookAt looked
#define lookAtRH looked_rh
#define lookAtLH looked_lh
namespace glm { template <typename T, qualifier Q> mat<4, 4, T, Q> turned(mat<4, 4, T, Q> const&, T, vec<3, T, Q> const&); }
#include "/usr/lib/llvm-14/include/llvm/../../glm/ext/matrix_transform.inl"
#undef rotate
#undef translate
#undef scale
#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {

glm::mat4 rotation_matrix(const AxisAngle& turn)
{
    if (turn.axis == glm::vec3(0)) return glm::mat4(1);
    return glm::turned(glm::mat4(1), turn.angle, turn.axis);
}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn) { return glm::vec3(rotation_matrix(turn) * glm::vec4(vector, 1)); }

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    glm::mat4 all(1);
    for (const AxisAngle& turn : turns) all = rotation_matrix(turn) * all;
    return all;
}

}
