// alternative: mirrors the viewer instead of the light, by twice the way to the foot on the normal; in long double
#include <umbral/lighting/diffuse.hpp>
#include <umbral/lighting/phong.hpp>

namespace umbral::lighting {
namespace {

using Vector = glm::vec<3, long double>;

Vector made_unit(const Vector& v) { return v == Vector(0) ? v : v / glm::length(v); }

Vector mirrored(const Vector& from, const Vector& n)
{
    const Vector foot = glm::dot(n, from) * n;
    return foot + (foot - from);
}

}

glm::vec3 mirrored_direction(const glm::vec3& l, const glm::vec3& normal)
{
    if (normal == glm::vec3(0)) return normal;
    return glm::vec3(mirrored(Vector(l), made_unit(Vector(normal))));
}

float phong_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    const Vector n = made_unit(Vector(normal));
    const Vector to_light = made_unit(Vector(l));
    const Vector to_viewer = made_unit(Vector(v));
    const bool is_in_front = glm::dot(n, to_light) > 0;
    if (!is_in_front || to_viewer == Vector(0)) return 0;
    const long double cosine = std::max(0.0L, glm::dot(mirrored(to_viewer, n), to_light));
    return static_cast<float>(std::min(1.0L, std::pow(cosine, static_cast<long double>(e))));
}

glm::vec3 phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                           const glm::vec3& global_ambient, const glm::vec3& eye)
{
    glm::vec3 shine(0);
    for (const Light& light : lights)
        shine += light.color * phong_highlight(at.normal, direction_to_light(light, at.position), eye - at.position,
                                               material.shininess);
    return matt_reflection(at, material, lights, global_ambient) + shine * material.specular;
}

}
