// In extended precision, and by other ways: the mirror's point by a search among points, comparing cosines; the horizon
// by its circle.

#include <cmath>
#include <umbral/lighting/brightest_point.hpp>

namespace umbral::lighting {
namespace {

using Vector = glm::vec<3, long double>;

Vector towards(const Light& light, const Vector& from)
{
    const Vector position(light.position);
    return normalize(light.position.w == 0 ? position : position - from);
}

Vector on_sphere(const Sphere& sphere, const Vector& direction)
{
    return Vector(sphere.centre) + static_cast<long double>(sphere.radius) * normalize(direction);
}

// n·l and n·v, where l and v are unit and n has the radius as its length.
struct Cosines {
    long double light, eye;
};

Cosines cosines(const Sphere& sphere, const Light& light, const glm::vec3& eye, const Vector& p)
{
    const Vector n = p - Vector(sphere.centre);
    return {dot(n, towards(light, p)), dot(n, normalize(Vector(eye) - p))};
}

}

glm::vec3 brightest_diffuse(const Sphere& sphere, const Light& light)
{
    return glm::vec3(on_sphere(sphere, towards(light, Vector(sphere.centre))));
}

bool is_seen(const Sphere& sphere, const glm::vec3& point, const glm::vec3& eye)
{
    return dot(Vector(point) - Vector(sphere.centre), Vector(eye) - Vector(point)) > 0;
}

std::optional<glm::vec3> brightest_seen(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    const Vector centre(sphere.centre);
    const Vector top = on_sphere(sphere, towards(light, centre));
    if (cosines(sphere, light, eye, top).eye > 0) return glm::vec3(top);
    // The horizon: the circle at right angles to the way to the eye, R² / d before the centre.
    const Vector b = Vector(eye) - centre;
    const Vector a = towards(light, centre);
    const Vector aside = a * dot(b, b) - b * dot(a, b);
    if (aside == Vector(0)) return std::nullopt;
    const long double square = static_cast<long double>(sphere.radius) * static_cast<long double>(sphere.radius);
    const Vector middle = square / dot(b, b) * b;
    const Vector p = centre + middle + std::sqrt(square - dot(middle, middle)) * normalize(aside);
    if (cosines(sphere, light, eye, p).light <= 0) return std::nullopt;
    return glm::vec3(p);
}

std::optional<glm::vec3> brightest_specular(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    const Vector centre(sphere.centre);
    const Vector to_eye = normalize(Vector(eye) - centre);
    // The corner of a triangle with the eye and, if the light is a place, the light, that lies nearest to the centre.
    const Vector way = light.position.w == 0 ? Vector(light.position) : Vector(light.position) - Vector(eye);
    const Vector from_eye = centre - Vector(eye);
    long double t = dot(way, way) > 0 ? std::max(0.0L, dot(from_eye, way) / dot(way, way)) : 0;
    if (light.position.w != 0) t = std::min(t, 1.0L);
    if (length(from_eye - t * way) <= static_cast<long double>(sphere.radius)) return std::nullopt;

    Vector near_light = towards(light, centre);
    Vector near_eye = to_eye;
    Vector n = near_light;
    for (int i = 0; i < 80; ++i) {
        n = normalize(near_light + near_eye);
        const Cosines there = cosines(sphere, light, eye, on_sphere(sphere, n));
        (there.light > there.eye ? near_light : near_eye) = n;
    }
    return glm::vec3(on_sphere(sphere, n));
}

}
