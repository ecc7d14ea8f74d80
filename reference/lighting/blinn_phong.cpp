// Based on: J. F. Blinn. Models of Light Reflection for Computer Synthesized Pictures. SIGGRAPH 1977.

#include <algorithm>
#include <cmath>
#include <umbral/lighting/blinn_phong.hpp>
#include <umbral/lighting/diffuse.hpp>

namespace umbral::lighting {
namespace {

// In double the squares of all floats are numbers above 0 and below infinity. `v` is not null.
glm::dvec3 unit(const glm::dvec3& v) { return v / length(v); }

// (0, 0, 0) if there is none.
glm::dvec3 halfway(const glm::vec3& l, const glm::vec3& v)
{
    // Products of floats are exact in double, so that this is null only if the directions are parallel or one is null.
    const glm::dvec3 plane = cross(glm::dvec3(l), glm::dvec3(v));
    if (plane == glm::dvec3(0) && dot(glm::dvec3(l), glm::dvec3(v)) <= 0) return plane;
    const glm::dvec3 a = unit(glm::dvec3(l));
    const glm::dvec3 b = unit(glm::dvec3(v));
    // Nearly opposite: hardly a digit of a + b would be left. But it lies in their plane at right angles to a - b.
    return dot(a, b) < -0.5 ? unit(cross(unit(plane), a - b)) : unit(a + b);
}

}

std::optional<glm::vec3> half_vector(const glm::vec3& l, const glm::vec3& v)
{
    const glm::dvec3 h = halfway(l, v);
    if (h == glm::dvec3(0)) return std::nullopt;
    return glm::vec3(h);
}

float blinn_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e)
{
    const glm::dvec3 n(normal);
    const glm::dvec3 h = halfway(l, v);
    // Light from behind makes no highlight; nor does a null normal, whose products are 0.
    if (dot(n, glm::dvec3(l)) <= 0 || h == glm::dvec3(0)) return 0;
    const double cosine = dot(unit(n), h);
    return static_cast<float>(std::pow(std::clamp(cosine, 0.0, 1.0), double{e}));
}

glm::vec3 blinn_phong_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                                 const glm::vec3& global_ambient, const glm::vec3& eye)
{
    glm::vec3 sum = matt_reflection(at, material, lights, global_ambient);
    for (const Light& light : lights)
        sum +=
            light.color * material.specular *
            blinn_highlight(at.normal, direction_to_light(light, at.position), eye - at.position, material.shininess);
    return sum;
}

}
