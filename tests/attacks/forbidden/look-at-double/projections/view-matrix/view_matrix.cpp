#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/projections/view.hpp>
namespace umbral::projections {
glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    const auto look = []<class T>(T e, T t, T w) { return glm::lookAt(e, t, w); };
    return glm::mat4(look(glm::dvec3(eye), glm::dvec3(target), glm::dvec3(up)));
}
}
