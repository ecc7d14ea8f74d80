// The definition itself, (l + v) / |l + v|, in 113 bits: of vectors that are opposite but for the last digit of a float
// enough of them are left. The power is taken in long double.

#include <algorithm>
#include <umbral/lighting/blinn_phong.hpp>
#include <umbral/lighting/diffuse.hpp>

#include "wide.hpp"

namespace umbral::lighting {
namespace {

struct WideVector {
    Wide x, y, z;
};

Wide dot_product(const WideVector& a, const WideVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

WideVector wide(const glm::vec3& v) { return {v.x, v.y, v.z}; }

bool are_opposite(const WideVector& a, const WideVector& b)
{
    return a.y * b.z == a.z * b.y && a.z * b.x == a.x * b.z && a.x * b.y == a.y * b.x && dot_product(a, b) < 0;
}

// Its length is left as it is; null if there is none.
WideVector halfway(const glm::vec3& l, const glm::vec3& v)
{
    const WideVector a = wide(l);
    const WideVector b = wide(v);
    const Wide sizes[] = {square_root(dot_product(a, a)), square_root(dot_product(b, b))};
    if (sizes[0] == 0 || sizes[1] == 0 || are_opposite(a, b)) return {0, 0, 0};
    return {a.x / sizes[0] + b.x / sizes[1], a.y / sizes[0] + b.y / sizes[1], a.z / sizes[0] + b.z / sizes[1]};
}

}

std::optional<glm::vec3> half_vector(const glm::vec3& l, const glm::vec3& v)
{
    const WideVector h = halfway(l, v);
    const Wide size = square_root(dot_product(h, h));
    if (size == 0) return std::nullopt;
    return glm::vec3(static_cast<float>(h.x / size), static_cast<float>(h.y / size), static_cast<float>(h.z / size));
}

float blinn_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    const WideVector n = wide(normal);
    const WideVector h = halfway(l, v);
    const Wide sizes = square_root(dot_product(h, h)) * square_root(dot_product(n, n));
    if (dot_product(n, wide(l)) <= 0 || sizes == 0) return 0;
    const auto cosine = static_cast<long double>(dot_product(n, h) / sizes);
    return static_cast<float>(std::pow(std::clamp(cosine, 0.0L, 1.0L), static_cast<long double>(e)));
}

glm::vec3 blinn_phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                                 const glm::vec3& global_ambient, const glm::vec3& eye)
{
    const glm::vec3 matt = matt_reflection(at, material, lights, global_ambient);
    Wide sum[3] = {matt.x, matt.y, matt.z};
    for (const Light& light : lights) {
        const float highlight =
            blinn_highlight(at.normal, direction_to_light(light, at.position), eye - at.position, material.shininess);
        for (int i = 0; i < 3; ++i) sum[i] += Wide{light.color[i]} * Wide{material.specular[i]} * Wide{highlight};
    }
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

}
