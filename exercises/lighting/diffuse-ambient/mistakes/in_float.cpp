// mistake: computes everything in float
// credit: 83..96
// hint: Where light grazes the surface, the cosine is the small difference of large products, and float leaves few
// digits of it; squares of very long or short vectors are no floats at all. Compute in double, and round once.
#include <umbral/lighting/diffuse.hpp>

namespace umbral::lighting {

glm::vec3 direction_to_light(const Light& light, const glm::vec3& point)
{
    const glm::vec3 way = glm::vec3(light.position) - light.position.w * point;
    return way == glm::vec3(0) ? way : normalize(way);
}

glm::vec3 matt_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                          const glm::vec3& global_ambient)
{
    const glm::vec3 n = at.normal == glm::vec3(0) ? at.normal : normalize(at.normal);
    glm::vec3 sum = material.emission + global_ambient * material.ambient;
    for (const Light& light : lights) {
        const float cosine = dot(n, direction_to_light(light, at.position));
        sum += light.color * (material.ambient + material.diffuse * std::max(0.0F, cosine));
    }
    return sum;
}

}
