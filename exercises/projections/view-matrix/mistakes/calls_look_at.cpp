// mistake: calls the function that it should write
// credit: 0..0
// hint: glm::lookAt is what you are asked to write. Start with the three axes of the camera.
// verdict: forbidden
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/projections/view.hpp>

namespace umbral::projections {

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    return glm::lookAt(eye, target, up);
}

}
