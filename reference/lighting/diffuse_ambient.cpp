// Based on: J. H. Lambert. Photometria. 1760 (the cosine law); the course's local illumination model, without its
// specular term.

#include <algorithm>
#include <umbral/lighting/diffuse.hpp>

namespace umbral::lighting {
namespace {

// In double the squares of all floats are numbers above 0 and below infinity.
glm::dvec3 unit_or_null(const glm::dvec3& v)
{
    const double size = length(v);
    return size > 0 ? v / size : glm::dvec3(0);
}

glm::dvec3 towards(const Light& light, const glm::dvec3& point)
{
    const glm::dvec3 position(light.position);
    return unit_or_null(light.position.w == 0 ? position : position - point);
}

}

glm::vec3 direction_to_light(const Light& light, const glm::vec3& point)
{
    return glm::vec3(towards(light, glm::dvec3(point)));
}

glm::vec3 matt_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                          const glm::vec3& global_ambient)
{
    const glm::dvec3 n = unit_or_null(glm::dvec3(at.normal));
    const glm::dvec3 ambient(material.ambient);
    const glm::dvec3 diffuse(material.diffuse);
    glm::dvec3 light_sent = glm::dvec3(material.emission) + glm::dvec3(global_ambient) * ambient;
    for (const Light& light : lights) {
        const double cosine = dot(n, towards(light, glm::dvec3(at.position)));
        light_sent += glm::dvec3(light.color) * (ambient + diffuse * std::max(0.0, cosine));
    }
    return glm::vec3(light_sent);
}

}
