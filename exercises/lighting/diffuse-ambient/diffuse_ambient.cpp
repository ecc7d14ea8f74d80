#include <umbral/lighting/diffuse.hpp>

namespace umbral::lighting {

glm::vec3 direction_to_light(const Light& light, const glm::vec3& point)
{
    // TODO: look at light.position.w: is it a place or a direction? Either way the result has the length 1, or 0 if
    // there is no direction.
    return not_implemented<glm::vec3>(light, point);
}

glm::vec3 matt_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                          const glm::vec3& global_ambient)
{
    // TODO: begin with what is there without any light; then add, for each of them, its ambient term and, if it stands
    // on the side of the normal, its diffuse one.
    return not_implemented<glm::vec3>(at, material, lights, global_ambient);
}

}
