#include <umbral/lighting/blinn_phong.hpp>

namespace umbral::lighting {

std::optional<glm::vec3> half_vector(const glm::vec3& l, const glm::vec3& v)
{
    // TODO: make both unit, add them, and make the sum unit. When is there no such vector?
    return not_implemented<std::optional<glm::vec3>>(l, v);
}

float blinn_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    // TODO: nothing if the light is behind the surface, or without a half vector; else the cosine between the normal
    // and the half vector, not below 0, to the power e.
    return not_implemented<float>(normal, l, v, e);
}

glm::vec3 blinn_phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                                 const glm::vec3& global_ambient, const glm::vec3& eye)
{
    // TODO: begin with matt_reflection, and add each light's highlight in the light's colour and the material's.
    return not_implemented<glm::vec3>(at, material, lights, global_ambient, eye);
}

}
