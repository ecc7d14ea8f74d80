// mistake: computes everything in float
// credit: 84..97
// hint: Of l + v hardly a digit is left in float where the two are nearly opposite, squares of very long or short
// vectors are no floats, and a power of 10,000 multiplies each error. Compute in double.
#include <umbral/lighting/blinn_phong.hpp>
#include <umbral/lighting/diffuse.hpp>

namespace umbral::lighting {

std::optional<glm::vec3> half_vector(const glm::vec3& l, const glm::vec3& v)
{
    if (l == glm::vec3(0) || v == glm::vec3(0)) return std::nullopt;
    const glm::vec3 sum = normalize(l) + normalize(v);
    if (length(sum) < 2e-7F) return std::nullopt;
    return normalize(sum);
}

float blinn_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    const std::optional<glm::vec3> h = half_vector(l, v);
    if (!h || dot(normal, l) <= 0) return 0;
    return std::pow(std::clamp(dot(normalize(normal), *h), 0.0F, 1.0F), e);
}

glm::vec3 blinn_phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                                 const glm::vec3& global_ambient, const glm::vec3& eye)
{
    glm::vec3 sum = matt_reflection(at, material, lights, global_ambient);
    for (const Light& light : lights) {
        const glm::vec3 l = direction_to_light(light, at.position);
        const float highlight = blinn_highlight(at.normal, l, eye - at.position, material.shininess);
        sum += light.color * material.specular * highlight;
    }
    return sum;
}

}
