// Based on: B. T. Phong. Illumination for Computer Generated Pictures. Communications of the ACM 18 (1975).

#include <algorithm>
#include <cmath>
#include <umbral/lighting/diffuse.hpp>
#include <umbral/lighting/phong.hpp>

namespace umbral::lighting {
namespace {

// In double the squares of all floats are numbers above 0 and below infinity.
glm::dvec3 unit_or_null(const glm::vec3& v)
{
    const double size = length(glm::dvec3(v));
    return size > 0 ? glm::dvec3(v) / size : glm::dvec3(0);
}

glm::dvec3 mirrored(const glm::dvec3& l, const glm::dvec3& n) { return 2 * dot(n, l) * n - l; }

}

glm::vec3 mirrored_direction(const glm::vec3& l, const glm::vec3& normal)
{
    const glm::dvec3 n = unit_or_null(normal);
    return n == glm::dvec3(0) ? glm::vec3(0) : glm::vec3(mirrored(glm::dvec3(l), n));
}

float phong_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    const glm::dvec3 n = unit_or_null(normal);
    const glm::dvec3 to_light = unit_or_null(l);
    const glm::dvec3 to_viewer = unit_or_null(v);
    // Light from behind makes no highlight. With a null vector there is nothing to mirror, or nobody to see it.
    if (dot(n, to_light) <= 0 || to_viewer == glm::dvec3(0)) return 0;
    const double cosine = dot(mirrored(to_light, n), to_viewer);
    return static_cast<float>(std::pow(std::clamp(cosine, 0.0, 1.0), double{e}));
}

glm::vec3 phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                           const glm::vec3& global_ambient, const glm::vec3& eye)
{
    glm::vec3 sum = matt_reflection(at, material, lights, global_ambient);
    for (const Light& light : lights)
        sum +=
            light.color * material.specular *
            phong_highlight(at.normal, direction_to_light(light, at.position), eye - at.position, material.shininess);
    return sum;
}

}
