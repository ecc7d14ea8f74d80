// alternative: the highlight by half_vector itself, which is rounded to float; its angle to the normal from the sine
// where the cosine would lose it
#include <umbral/lighting/blinn_phong.hpp>
#include <umbral/lighting/diffuse.hpp>

namespace umbral::lighting {

std::optional<glm::vec3> half_vector(const glm::vec3& l, const glm::vec3& v)
{
    const glm::dvec3 a(l);
    const glm::dvec3 b(v);
    const double sizes = glm::length(a) * glm::length(b);
    if (sizes == 0 || (glm::cross(a, b) == glm::dvec3(0) && glm::dot(a, b) < 0)) return std::nullopt;
    return glm::vec3(glm::normalize(a / glm::length(a) + b / glm::length(b)));
}

float blinn_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    const auto h = half_vector(l, v);
    const glm::dvec3 n(normal);
    if (!h || glm::dot(n, glm::dvec3(l)) <= 0) return 0;
    const double cosine = glm::dot(n, glm::dvec3(*h));
    if (cosine <= 0) return e == 0 ? 1.0F : 0.0F;
    // The rounded vector is off by its last digits: its tangent does not care how long it is.
    const double tangent = glm::length(glm::cross(n, glm::dvec3(*h))) / cosine;
    return static_cast<float>(std::exp(-0.5 * e * std::log1p(tangent * tangent)));
}

glm::vec3 blinn_phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                                 const glm::vec3& global_ambient, const glm::vec3& eye)
{
    glm::vec3 sum = matt_reflection(at, material, lights, global_ambient);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const glm::vec3 l = direction_to_light(lights[i], at.position);
        sum +=
            blinn_highlight(at.normal, l, eye - at.position, material.shininess) * lights[i].color * material.specular;
    }
    return sum;
}

}
