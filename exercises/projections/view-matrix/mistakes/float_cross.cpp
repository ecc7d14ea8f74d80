// mistake: forms u × n in float
// credit: 70..82
// hint: If up is almost parallel to the view, u × n subtracts products that agree in nearly all their digits. Form it
// in double.
#include <cmath>
#include <umbral/projections/view.hpp>

namespace umbral::projections {
namespace {

glm::vec3 replacement(const glm::vec3& z)
{
    int best = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(z[axis]) < std::abs(z[best])) best = axis;
    glm::vec3 chosen(0);
    chosen[best] = 1;
    return chosen;
}

}

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    const glm::vec3 o(eye);
    const glm::vec3 n = eye == target ? glm::vec3(0, 0, 1) : o - glm::vec3(target);
    const glm::vec3 z = normalize(n);
    glm::vec3 u(up);
    if (length(cross(u, z)) < 1e-6F * length(u) || length(u) == 0) u = replacement(z);
    const glm::vec3 x = normalize(cross(u, z));
    const glm::vec3 y = cross(z, x);
    glm::mat4 view(1);
    for (int i = 0; i < 3; ++i) {
        view[i][0] = x[i];
        view[i][1] = y[i];
        view[i][2] = z[i];
    }
    view[3] = glm::vec4(-dot(x, o), -dot(y, o), -dot(z, o), 1);
    return glm::mat4(view);
}

}
