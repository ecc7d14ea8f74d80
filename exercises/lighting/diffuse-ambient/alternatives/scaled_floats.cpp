// alternative: vectors scaled by their largest component before their squares are taken; the dot product of vectors
// that are not unit yet, divided once; ambient light gathered apart
#include <umbral/lighting/diffuse.hpp>

namespace umbral::lighting {
namespace {

glm::dvec3 scaled(const glm::dvec3& v)
{
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest == 0 ? v : v / largest;
}

glm::dvec3 way(const Light& light, const glm::vec3& point)
{
    return scaled(glm::dvec3(light.position) - double{light.position.w} * glm::dvec3(point));
}

}

glm::vec3 direction_to_light(const Light& light, const glm::vec3& point)
{
    const glm::dvec3 v = way(light, point);
    if (v == glm::dvec3(0)) return glm::vec3(0);
    return glm::vec3(v * (1 / std::sqrt(dot(v, v))));
}

glm::vec3 matt_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                          const glm::vec3& global_ambient)
{
    const glm::dvec3 n = scaled(glm::dvec3(at.normal));
    glm::dvec3 flat(global_ambient);
    glm::dvec3 lit(0);
    for (const Light& light : lights) {
        flat += glm::dvec3(light.color);
        const glm::dvec3 v = way(light, at.position);
        const double product = dot(n, v);
        if (product <= 0) continue;
        lit += glm::dvec3(light.color) * (product / std::sqrt(dot(n, n) * dot(v, v)));
    }
    return glm::vec3(glm::dvec3(material.emission) + flat * glm::dvec3(material.ambient) +
                     lit * glm::dvec3(material.diffuse));
}

}
