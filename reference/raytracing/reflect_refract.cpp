// Based on: A. S. Glassner (editor). An Introduction to Ray Tracing. 1989, chapter 4, 4: reflection, and refraction by
// Snell's law as vectors (P. Heckbert's method).

#include <cmath>
#include <umbral/raytracing/reflect_refract.hpp>

namespace umbral::raytracing {
namespace {

glm::dvec3 unit(const glm::vec3& v) { return normalize(glm::dvec3(v)); }

}

glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n)
{
    const glm::dvec3 viewer = unit(v);
    const glm::dvec3 normal = unit(n);
    return glm::vec3(2 * dot(normal, viewer) * normal - viewer);
}

std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float outside, float inside)
{
    const glm::dvec3 viewer = unit(v);
    glm::dvec3 normal = unit(n);
    double ratio = double{outside} / inside;
    if (dot(normal, viewer) < 0) {  // from inside: all is mirrored in the surface
        normal = -normal;
        ratio = double{inside} / outside;
    }
    // The part of the viewer's direction along the surface is as long as the sine, and Snell's law says how long that
    // of the refracted direction is. It leads the opposite way.
    const double cosine = dot(normal, viewer);
    const glm::dvec3 along = ratio * (cosine * normal - viewer);
    const double cosine_squared = 1 - dot(along, along);
    if (cosine_squared < 0) return std::nullopt;
    return glm::vec3(along - std::sqrt(cosine_squared) * normal);
}

std::optional<float> critical_angle(float from, float into)
{
    if (into >= from) return std::nullopt;
    return static_cast<float>(std::asin(double{into} / from));
}

}
