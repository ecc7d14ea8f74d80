// alternative: the sum of unit vectors in double, asked whether it is null by the exact cross product; the whole model
// written out
#include <umbral/lighting/blinn_phong.hpp>

namespace umbral::lighting {
namespace {

glm::dvec3 made_unit(const glm::dvec3& v) { return v == glm::dvec3(0) ? v : glm::normalize(v); }

}

std::optional<glm::vec3> half_vector(const glm::vec3& l, const glm::vec3& v)
{
    const glm::dvec3 a(l);
    const glm::dvec3 b(v);
    const bool parallel = glm::cross(a, b) == glm::dvec3(0);
    if (parallel && glm::dot(a, b) <= 0) return std::nullopt;
    return glm::vec3(glm::normalize(made_unit(a) + made_unit(b)));
}

float blinn_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    if (!half_vector(l, v)) return 0;
    const glm::dvec3 n = made_unit(normal);
    if (!(glm::dot(n, glm::dvec3(l)) > 0)) return 0;
    const glm::dvec3 sum = made_unit(l) + made_unit(v);
    const double cosine = glm::dot(n, sum) / glm::length(sum);
    if (cosine <= 0) return e == 0 ? 1 : 0;
    return static_cast<float>(std::exp(e * std::log(std::min(cosine, 1.0))));
}

glm::vec3 blinn_phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                                 const glm::vec3& global_ambient, const glm::vec3& eye)
{
    glm::vec3 sum = material.emission + global_ambient * material.ambient;
    for (const Light& light : lights) {
        glm::vec3 l(light.position);
        if (light.position.w == 1) l -= at.position;
        const auto cosine = static_cast<float>(glm::dot(made_unit(l), made_unit(at.normal)));
        glm::vec3 reflectance = material.ambient + std::max(cosine, 0.0F) * material.diffuse;
        reflectance += blinn_highlight(at.normal, l, eye - at.position, material.shininess) * material.specular;
        sum += light.color * reflectance;
    }
    return sum;
}

}
