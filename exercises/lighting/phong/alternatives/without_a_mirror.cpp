// alternative: r·v by three dot products of the vectors as they are, divided once; the whole model written out
#include <umbral/lighting/phong.hpp>

namespace umbral::lighting {

glm::vec3 mirrored_direction(const glm::vec3& l, const glm::vec3& normal)
{
    const glm::dvec3 n(normal);
    const double square = dot(n, n);
    if (square == 0) return {0, 0, 0};
    return glm::vec3((2 * dot(n, glm::dvec3(l)) / square) * n - glm::dvec3(l));
}

float phong_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    const glm::dvec3 n(normal);
    const glm::dvec3 a(l);
    const glm::dvec3 b(v);
    if (!(dot(n, a) > 0) || v == glm::vec3(0)) return 0;
    const double product = 2 * dot(n, a) * dot(n, b) / dot(n, n) - dot(a, b);
    const double cosine = product / (glm::length(a) * glm::length(b));
    if (cosine <= 0) return e == 0 ? 1.0F : 0.0F;
    return static_cast<float>(std::exp(e * std::log(std::min(cosine, 1.0))));
}

glm::vec3 phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                           const glm::vec3& global_ambient, const glm::vec3& eye)
{
    glm::vec3 sum = material.emission + global_ambient * material.ambient;
    for (const Light& light : lights) {
        glm::vec3 l(light.position);
        if (light.position.w == 1) l -= at.position;
        const float sizes = glm::length(l) * glm::length(at.normal);
        const float cosine = sizes > 0 ? glm::dot(l, at.normal) / sizes : 0;
        glm::vec3 reflectance = material.ambient + std::max(cosine, 0.0F) * material.diffuse;
        reflectance += phong_highlight(at.normal, l, eye - at.position, material.shininess) * material.specular;
        sum += light.color * reflectance;
    }
    return sum;
}

}
