// Vectors in 113 bits, by r·v = 2 (n·l) (n·v) - l·v; the power in long double.

#include <algorithm>
#include <umbral/lighting/diffuse.hpp>
#include <umbral/lighting/phong.hpp>

#include "wide.hpp"

namespace umbral::lighting {
namespace {

Wide dot_product(const glm::vec3& a, const glm::vec3& b)
{
    return Wide{a.x} * Wide{b.x} + Wide{a.y} * Wide{b.y} + Wide{a.z} * Wide{b.z};
}

}

glm::vec3 mirrored_direction(const glm::vec3& l, const glm::vec3& normal)
{
    const Wide square = dot_product(normal, normal);
    if (square == 0) return glm::vec3(0);
    const Wide factor = 2 * dot_product(normal, l) / square;
    glm::vec3 r;
    for (int i = 0; i < 3; ++i) r[i] = static_cast<float>(factor * Wide{normal[i]} - Wide{l[i]});
    return r;
}

float phong_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    const Wide nl = dot_product(normal, l);
    const Wide sizes = square_root(dot_product(l, l)) * square_root(dot_product(v, v));
    if (nl <= 0 || sizes == 0) return 0;
    const Wide product = 2 * nl * dot_product(normal, v) / dot_product(normal, normal) - dot_product(l, v);
    const auto cosine = static_cast<long double>(product / sizes);
    return static_cast<float>(std::pow(std::clamp(cosine, 0.0L, 1.0L), static_cast<long double>(e)));
}

glm::vec3 phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                           const glm::vec3& global_ambient, const glm::vec3& eye)
{
    const glm::vec3 matt = matt_reflection(at, material, lights, global_ambient);
    Wide sum[3] = {matt.x, matt.y, matt.z};
    for (const Light& light : lights) {
        const float highlight =
            phong_highlight(at.normal, direction_to_light(light, at.position), eye - at.position, material.shininess);
        for (int i = 0; i < 3; ++i) sum[i] += Wide{light.color[i]} * Wide{material.specular[i]} * Wide{highlight};
    }
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

}
