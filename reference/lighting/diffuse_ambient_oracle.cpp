// The same formula, written for components, in 113 bits and rounded once. Squares of floats neither vanish nor overflow
// there.

#include <umbral/lighting/diffuse.hpp>

#include "wide.hpp"

namespace umbral::lighting {
namespace {

struct WideVector {
    Wide x, y, z;
};

WideVector unit_or_null(const WideVector& v)
{
    const Wide square = v.x * v.x + v.y * v.y + v.z * v.z;
    if (square == 0) return v;
    const Wide size = square_root(square);
    return {v.x / size, v.y / size, v.z / size};
}

WideVector towards(const Light& light, const glm::vec3& point)
{
    const Wide w = light.position.w;  // 1 or 0
    return unit_or_null({Wide{light.position.x} - w * Wide{point.x}, Wide{light.position.y} - w * Wide{point.y},
                         Wide{light.position.z} - w * Wide{point.z}});
}

}

glm::vec3 direction_to_light(const Light& light, const glm::vec3& point)
{
    const auto [x, y, z] = towards(light, point);
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

glm::vec3 matt_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                          const glm::vec3& global_ambient)
{
    const WideVector n = unit_or_null({at.normal.x, at.normal.y, at.normal.z});
    glm::vec3 result;
    for (int i = 0; i < 3; ++i) {
        Wide sum = Wide{material.emission[i]} + Wide{global_ambient[i]} * Wide{material.ambient[i]};
        for (const Light& light : lights) {
            const WideVector l = towards(light, at.position);
            const Wide cosine = n.x * l.x + n.y * l.y + n.z * l.z;
            sum += Wide{light.color[i]} * Wide{material.ambient[i]};
            if (cosine > 0) sum += Wide{light.color[i]} * Wide{material.diffuse[i]} * cosine;
        }
        result[i] = static_cast<float>(sum);
    }
    return result;
}

}
