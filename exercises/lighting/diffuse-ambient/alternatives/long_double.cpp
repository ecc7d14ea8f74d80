// alternative: everything in long double, by vectors of GLM
#include <umbral/lighting/diffuse.hpp>

namespace umbral::lighting {
namespace {

using Vector = glm::vec<3, long double>;

Vector made_unit(const Vector& v) { return v == Vector(0) ? v : glm::normalize(v); }

Vector to_light(const Light& light, const glm::vec3& point)
{
    if (light.position.w == 0) return made_unit(Vector(light.position.x, light.position.y, light.position.z));
    return made_unit(Vector(light.position.x, light.position.y, light.position.z) - Vector(point));
}

}

glm::vec3 direction_to_light(const Light& light, const glm::vec3& point) { return glm::vec3(to_light(light, point)); }

glm::vec3 matt_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                          const glm::vec3& global_ambient)
{
    Vector sum = Vector(global_ambient) * Vector(material.ambient) + Vector(material.emission);
    const Vector n = made_unit(Vector(at.normal));
    for (const Light& light : lights) {
        const long double cosine = std::clamp<long double>(glm::dot(to_light(light, at.position), n), 0, 1);
        sum += Vector(light.color) * Vector(material.ambient) + cosine * Vector(light.color) * Vector(material.diffuse);
    }
    return glm::vec3(sum);
}

}
