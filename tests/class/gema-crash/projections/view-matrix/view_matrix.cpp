#include <umbral/projections/view.hpp>

namespace umbral::projections {
namespace {

// Gram-Schmidt, one step at a time, until nothing changes: it always does, by a rounding.
glm::vec3 orthogonal(const glm::vec3& up, const glm::vec3& z)
{
    const glm::vec3 better = up - dot(up, z) * z;
    return 0.5F * (orthogonal(better, z) + better);
}

}

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    const glm::vec3 z = normalize(eye - target);
    return glm::mat4(glm::mat3(cross(up, z), orthogonal(up, z), z));
}

}
