// mistake: the textbook as it stands: NaN where up is parallel to the view
// credit: 60..72
// hint: Look straight down with the usual up vector: u × n is zero, and so is its length. The interface's comment says
// what to do then.
#include <umbral/projections/view.hpp>

namespace umbral::projections {

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    const glm::vec3 z = normalize(eye - target);
    const glm::vec3 x = normalize(cross(up, z));
    const glm::vec3 y = cross(z, x);
    glm::mat4 view(1);
    for (int i = 0; i < 3; ++i) {
        view[i][0] = x[i];
        view[i][1] = y[i];
        view[i][2] = z[i];
    }
    view[3] = glm::vec4(-dot(x, eye), -dot(y, eye), -dot(z, eye), 1);
    return view;
}

}
