// alternative: |v| l + |l| v in long double, which needs no unit vectors
#include <umbral/lighting/blinn_phong.hpp>
#include <umbral/lighting/diffuse.hpp>

namespace umbral::lighting {
namespace {

using Vector = glm::vec<3, long double>;

// Of any length; null if there is none.
Vector bisector(const glm::vec3& l, const glm::vec3& v)
{
    const Vector a(l);
    const Vector b(v);
    if (glm::cross(a, b) == Vector(0) && glm::dot(a, b) <= 0) return Vector(0);
    return glm::length(b) * a + glm::length(a) * b;
}

}

std::optional<glm::vec3> half_vector(const glm::vec3& l, const glm::vec3& v)
{
    const Vector h = bisector(l, v);
    if (h == Vector(0)) return {};
    return glm::vec3(h / glm::length(h));
}

float blinn_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    const Vector n(normal);
    const Vector h = bisector(l, v);
    const bool shines = glm::dot(n, Vector(l)) > 0 && h != Vector(0);
    if (!shines) return 0;
    const long double cosine = glm::dot(n, h) / (glm::length(n) * glm::length(h));
    return static_cast<float>(std::pow(std::clamp(cosine, 0.0L, 1.0L), static_cast<long double>(e)));
}

glm::vec3 blinn_phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                                 const glm::vec3& global_ambient, const glm::vec3& eye)
{
    glm::vec3 shine(0);
    for (const Light& light : lights)
        shine += light.color * blinn_highlight(at.normal, direction_to_light(light, at.position), eye - at.position,
                                               material.shininess);
    return shine * material.specular + matt_reflection(at, material, lights, global_ambient);
}

}
