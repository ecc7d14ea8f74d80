// alternative: vectors made unit by std::hypot, channels one by one, the diffuse term added only where there is one
#include <umbral/lighting/diffuse.hpp>

namespace umbral::lighting {
namespace {

struct Vector {
    double x, y, z;
};

Vector unit(double x, double y, double z)
{
    const double size = std::hypot(x, y, z);
    if (size == 0) return {0, 0, 0};
    return {x / size, y / size, z / size};
}

Vector towards(const Light& light, const glm::vec3& p)
{
    const glm::vec4& q = light.position;
    if (q.w == 1) return unit(double{q.x} - p.x, double{q.y} - p.y, double{q.z} - p.z);
    return unit(q.x, q.y, q.z);
}

}

glm::vec3 direction_to_light(const Light& light, const glm::vec3& point)
{
    const auto [x, y, z] = towards(light, point);
    return glm::vec3(x, y, z);
}

glm::vec3 matt_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                          const glm::vec3& global_ambient)
{
    const auto [nx, ny, nz] = unit(at.normal.x, at.normal.y, at.normal.z);
    std::array<double, 3> sum{};
    for (int i = 0; i < 3; ++i) sum[i] = material.emission[i] + double{global_ambient[i]} * material.ambient[i];
    for (const Light& light : lights) {
        const auto [x, y, z] = towards(light, at.position);
        const double cosine = nx * x + ny * y + nz * z;
        for (int i = 0; i < 3; ++i) {
            sum[i] += double{light.color[i]} * material.ambient[i];
            if (cosine > 0) sum[i] += double{light.color[i]} * material.diffuse[i] * cosine;
        }
    }
    return {sum[0], sum[1], sum[2]};
}

}
