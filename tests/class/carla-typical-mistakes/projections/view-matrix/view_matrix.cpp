#include <cmath>
#include <umbral/projections/view.hpp>

namespace umbral::projections {
namespace {

glm::dvec3 replacement(const glm::dvec3& z)
{
    int best = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(z[axis]) < std::abs(z[best])) best = axis;
    glm::dvec3 chosen(0);
    chosen[best] = 1;
    return chosen;
}

}

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    const glm::dvec3 o(eye);
    const glm::dvec3 n = eye == target ? glm::dvec3(0, 0, 1) : o - glm::dvec3(target);
    const glm::dvec3 z = normalize(n);
    glm::dvec3 u(up);
    if (length(cross(u, z)) < 1e-6 * length(u) || length(u) == 0) u = replacement(z);
    const glm::dvec3 x = normalize(cross(u, z));
    const glm::dvec3 y = cross(z, x);
    glm::dmat4 view(1);
    for (int i = 0; i < 3; ++i) {
        view[0][i] = x[i];
        view[1][i] = y[i];
        view[2][i] = z[i];
    }
    view[3] = glm::dvec4(-dot(x, o), -dot(y, o), -dot(z, o), 1);
    return glm::mat4(view);
}

}
