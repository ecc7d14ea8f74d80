// alternative: in the plane of incidence, with angles, sines and cosines
#include <cmath>
#include <numbers>
#include <umbral/raytracing/reflect_refract.hpp>

namespace umbral::raytracing {
namespace {

/// The plane of incidence: the normal on the viewer's side, and the direction along the surface away from the viewer.
struct Plane {
    glm::dvec3 up;
    glm::dvec3 away;
    double angle;  ///< of incidence
    bool from_inside;
};

Plane plane_of(const glm::vec3& v, const glm::vec3& n)
{
    const glm::dvec3 i = glm::dvec3(v) / length(glm::dvec3(v));
    const glm::dvec3 normal = glm::dvec3(n) / length(glm::dvec3(n));
    Plane plane;
    plane.from_inside = dot(i, normal) < 0;
    plane.up = plane.from_inside ? -normal : normal;
    const glm::dvec3 across = dot(i, plane.up) * plane.up - i;
    const double sine = length(across);
    plane.away = sine > 0 ? across / sine : glm::dvec3(0);
    plane.angle = std::atan2(sine, dot(i, plane.up));
    return plane;
}

}

glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n)
{
    const Plane plane = plane_of(v, n);
    return glm::vec3(std::cos(plane.angle) * plane.up + std::sin(plane.angle) * plane.away);
}

std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float outside, float inside)
{
    const Plane plane = plane_of(v, n);
    const double from = plane.from_inside ? inside : outside;
    const double into = plane.from_inside ? outside : inside;
    const double sine = std::sin(plane.angle) * from / into;
    if (sine > 1) return {};
    const double angle = std::asin(sine);
    return glm::vec3(std::sin(angle) * plane.away - std::cos(angle) * plane.up);
}

std::optional<float> critical_angle(float from, float into)
{
    if (from <= into) return {};
    const double a = from;
    const double b = into;
    return static_cast<float>(std::numbers::pi / 2 - std::acos(b / a));
}

}
