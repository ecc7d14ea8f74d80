// Based on: the course's problem 3.9; Alhazen's problem (Ibn al-Haytham. Book of Optics. About 1021), solved by an
// angle.

#include <algorithm>
#include <cmath>
#include <umbral/lighting/brightest_point.hpp>

namespace umbral::lighting {
namespace {

/// All happens on the great circle through the directions of light and eye, as the centre sees them. A point of it is
/// an angle: 0 is below the light, `angle` below the eye.
struct GreatCircle {
    glm::dvec3 to_light;  // unit
    glm::dvec3 aside;    // unit, at right angles to it, on the eye's side; null if the eye is straight before or behind
    double angle;        // between light and eye, 0 to π
    double cosine_lit;   // points at angles with a greater cosine than this to the light are lit: R / |q - c|
    double cosine_seen;  // to the eye, are seen
};

glm::dvec3 direction_from_centre(const Sphere& sphere, const Light& light)
{
    const glm::dvec3 position(light.position);
    return light.position.w == 0 ? position : position - glm::dvec3(sphere.centre);
}

GreatCircle great_circle(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    const glm::dvec3 a = direction_from_centre(sphere, light);
    const glm::dvec3 b = glm::dvec3(eye) - glm::dvec3(sphere.centre);
    const glm::dvec3 plane = cross(a, b);
    const glm::dvec3 aside = cross(plane, a);
    const double size = length(aside);
    return {normalize(a), size > 0 ? aside / size : glm::dvec3(0), std::atan2(length(plane), dot(a, b)),
            light.position.w == 0 ? 0 : sphere.radius / length(a), sphere.radius / length(b)};
}

glm::vec3 point_at(const Sphere& sphere, const GreatCircle& circle, double angle)
{
    const glm::dvec3 n = std::cos(angle) * circle.to_light + std::sin(angle) * circle.aside;
    return glm::vec3(glm::dvec3(sphere.centre) + double{sphere.radius} * n);
}

}

glm::vec3 brightest_diffuse(const Sphere& sphere, const Light& light)
{
    const glm::dvec3 n = normalize(direction_from_centre(sphere, light));
    return glm::vec3(glm::dvec3(sphere.centre) + double{sphere.radius} * n);
}

bool is_seen(const Sphere& sphere, const glm::vec3& point, const glm::vec3& eye)
{
    const glm::dvec3 p(point);
    return dot(p - glm::dvec3(sphere.centre), glm::dvec3(eye) - p) > 0;
}

std::optional<glm::vec3> brightest_seen(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    const GreatCircle circle = great_circle(sphere, light, eye);
    // n·l falls with the angle to the light, so that the nearest seen point is the brightest.
    const double nearest = std::max(0.0, circle.angle - std::acos(circle.cosine_seen));
    if (nearest >= std::acos(circle.cosine_lit)) return std::nullopt;
    return point_at(sphere, circle, nearest);
}

std::optional<glm::vec3> brightest_specular(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    const GreatCircle circle = great_circle(sphere, light, eye);
    if (circle.angle >= std::acos(circle.cosine_seen) + std::acos(circle.cosine_lit)) return std::nullopt;

    // A triangle of the centre, a point of the circle and the light has the sides R and |q - c|, which enclose the
    // angle x. So the tangent of the light's angle to the normal is sin x / (cos x - R / |q - c|); likewise the eye's.
    // The first one grows with x, and the other one falls.
    double low = 0;
    double high = circle.angle;
    double middle = 0.5 * circle.angle;
    while (low < middle && middle < high) {
        const double rest = circle.angle - middle;
        const bool is_nearer_to_the_light = std::sin(middle) * (std::cos(rest) - circle.cosine_seen) <
                                            std::sin(rest) * (std::cos(middle) - circle.cosine_lit);
        (is_nearer_to_the_light ? low : high) = middle;
        middle = 0.5 * (low + high);
    }
    return point_at(sphere, circle, middle);
}

}
