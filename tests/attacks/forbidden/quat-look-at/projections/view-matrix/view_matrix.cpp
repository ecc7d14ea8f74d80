#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/projections/view.hpp>
namespace umbral::projections {
glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    return glm::mat4(glm::translate(glm::mat4_cast(glm::conjugate(glm::quatLookAt(glm::normalize(target - eye), glm::normalize(up)))), -eye));
}
}
