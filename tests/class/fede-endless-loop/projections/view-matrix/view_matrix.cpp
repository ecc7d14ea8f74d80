#include <umbral/projections/view.hpp>

namespace umbral::projections {

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    const glm::dvec3 e(eye);
    const glm::dvec3 n = e - glm::dvec3(target);
    const glm::dvec3 z = n / length(n);
    glm::dvec3 u(up);
    // If up is parallel to the view, nudge it until it is not. A zero vector stays zero for ever.
    while (length(cross(u, z)) <= 1e-9) u += 0.01 * glm::dvec3(u.y, u.z, u.x);
    const glm::dvec3 x = normalize(cross(u, z));
    const glm::dvec3 y = cross(z, x);
    return glm::mat4(glm::dmat4(x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0, -dot(x, e), -dot(y, e), -dot(z, e), 1));
}

}
