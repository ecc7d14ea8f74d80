#include <umbral/lighting/phong.hpp>

namespace umbral::lighting {

glm::vec3 mirrored_direction(const glm::vec3& l, const glm::vec3& normal)
{
    // TODO: 2 (n·l) n - l, with n the normal made unit.
    return not_implemented<glm::vec3>(l, normal);
}

float phong_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    // TODO: make the three vectors unit; nothing if the light is behind the surface; else the cosine between the
    // mirrored direction and the viewer's, not below 0, to the power e.
    return not_implemented<float>(normal, l, v, e);
}

glm::vec3 phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                           const glm::vec3& global_ambient, const glm::vec3& eye)
{
    // TODO: begin with matt_reflection, and add each light's highlight in the light's colour and the material's.
    return not_implemented<glm::vec3>(at, material, lights, global_ambient, eye);
}

}
