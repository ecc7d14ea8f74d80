#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtc/matrix_transform.hpp>
template <auto F> struct Looks { static auto at(auto... words) { return F(words...); } };
#include <umbral/projections/view.hpp>
namespace umbral::projections {
glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    return Looks<&glm::lookAt<float, glm::defaultp>>::at(eye, target, up);
}
}
