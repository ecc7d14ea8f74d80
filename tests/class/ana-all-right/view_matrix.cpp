#include <umbral/projections/view.hpp>

namespace umbral::projections {

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    const glm::dvec3 e(eye);
    glm::dvec3 back(0, 0, 1);
    if (eye != target) back = normalize(e - glm::dvec3(target));

    glm::dvec3 right = cross(glm::dvec3(up), back);
    if (up == glm::vec3(0) || length(right) < 1e-6 * length(glm::dvec3(up))) {
        // up says nothing: take the world axis that the camera looks along least
        int least = 0;
        for (int i = 1; i < 3; ++i)
            if (std::abs(back[i]) < std::abs(back[least])) least = i;
        glm::dvec3 axis(0);
        axis[least] = 1;
        right = cross(axis, back);
    }
    right = normalize(right);
    const glm::dvec3 above = cross(back, right);

    glm::mat4 v(1);
    const glm::dvec3 axes[3] = {right, above, back};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) v[column][row] = static_cast<float>(axes[row][column]);
        v[3][row] = static_cast<float>(-dot(axes[row], e));
    }
    return v;
}

}
