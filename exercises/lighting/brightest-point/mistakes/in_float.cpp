// mistake: computes in float
// credit: 82..96
// hint: Close above the surface, or near the edge of what is lit and seen, a difference of nearly equal numbers
// decides: in float few digits of it are left. Compute in double and round the point.
#include <umbral/lighting/brightest_point.hpp>

namespace umbral::lighting {
namespace {

using Vector = glm::vec3;

Vector unit_towards(const Light& light, const Vector& from)
{
    const Vector q(light.position);
    return glm::normalize(light.position.w == 1 ? q - from : q);
}

Vector surface_point(const Sphere& s, const Vector& n) { return Vector(s.centre) + n * s.radius; }

float lit(const Sphere& s, const Light& light, const Vector& n)
{
    return glm::dot(n, unit_towards(light, surface_point(s, n)));
}

float seen(const Sphere& s, const glm::vec3& eye, const Vector& n)
{
    return glm::dot(n, glm::normalize(Vector(eye) - surface_point(s, n)));
}

}

glm::vec3 brightest_diffuse(const Sphere& sphere, const Light& light)
{
    return glm::vec3(surface_point(sphere, unit_towards(light, Vector(sphere.centre))));
}

bool is_seen(const Sphere& sphere, const glm::vec3& point, const glm::vec3& eye)
{
    const Vector n = Vector(point) - Vector(sphere.centre);
    const Vector v = Vector(eye) - Vector(point);
    return glm::dot(n, v) > 0;
}

std::optional<glm::vec3> brightest_seen(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    Vector hidden = unit_towards(light, Vector(sphere.centre));
    if (seen(sphere, eye, hidden) > 0) return glm::vec3(surface_point(sphere, hidden));
    Vector visible = glm::normalize(Vector(eye) - Vector(sphere.centre));
    if (glm::length(hidden + visible) < 1e-6F) return std::nullopt;
    for (int i = 0; i < 100; ++i) {
        const Vector middle = glm::normalize(hidden + visible);
        (seen(sphere, eye, middle) > 0 ? visible : hidden) = middle;
    }
    if (lit(sphere, light, visible) <= 0) return std::nullopt;
    return glm::vec3(surface_point(sphere, visible));
}

std::optional<glm::vec3> brightest_specular(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    Vector a = unit_towards(light, Vector(sphere.centre));
    Vector b = glm::normalize(Vector(eye) - Vector(sphere.centre));
    if (glm::length(a + b) < 1e-6F) return std::nullopt;
    Vector n = a;
    for (int i = 0; i < 100; ++i) {
        n = glm::normalize(a + b);
        (lit(sphere, light, n) > seen(sphere, eye, n) ? a : b) = n;
    }
    if (lit(sphere, light, n) <= 0) return std::nullopt;
    return glm::vec3(surface_point(sphere, n));
}

}
