// mistake: computes everything in float
// credit: 86..97
// hint: A cosine near 1 is off by a few 1e-8 in float, and a power of 10,000 makes ten thousand times as much of it; at
// the terminator such errors decide whether there is light at all. Compute the cosines in double.
#include <umbral/lighting/diffuse.hpp>
#include <umbral/lighting/phong.hpp>

namespace umbral::lighting {

glm::vec3 mirrored_direction(const glm::vec3& l, const glm::vec3& normal)
{
    if (normal == glm::vec3(0)) return glm::vec3(0);
    const glm::vec3 n = normalize(normal);
    return 2 * dot(n, l) * n - l;
}

float phong_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    if (normal == glm::vec3(0) || l == glm::vec3(0) || v == glm::vec3(0)) return 0;
    const glm::vec3 to_light = normalize(l);
    if (dot(normalize(normal), to_light) <= 0) return 0;
    const float cosine = dot(mirrored_direction(to_light, normal), normalize(v));
    return std::pow(std::clamp(cosine, 0.0F, 1.0F), e);
}

glm::vec3 phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                           const glm::vec3& global_ambient, const glm::vec3& eye)
{
    glm::vec3 sum = matt_reflection(at, material, lights, global_ambient);
    for (const Light& light : lights) {
        const glm::vec3 l = direction_to_light(light, at.position);
        const float highlight = phong_highlight(at.normal, l, eye - at.position, material.shininess);
        sum += light.color * material.specular * highlight;
    }
    return sum;
}

}
