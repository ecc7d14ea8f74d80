#include <umbral/projections/view.hpp>

namespace umbral::projections {

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    if (length(cross(up, eye - target)) < 1e-5F) return not_implemented<glm::mat4>(up);  // later
    const glm::vec3 z = normalize(eye - target);
    const glm::vec3 x = normalize(cross(up, z));
    const glm::vec3 y = cross(z, x);
    return glm::mat4(x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1);
}

}
