// alternative: Fermat's principle: the highlight lies where the way from the light over the sphere to the eye is
// shortest, by the sign of its derivative; the horizon from its circle; in long double
#include <umbral/lighting/brightest_point.hpp>

namespace umbral::lighting {
namespace {

using Real = long double;
using Vector = glm::vec<3, Real>;

Real radius_of(const Sphere& sphere) { return static_cast<Real>(sphere.radius); }

/// What the light's direction is from the centre: not unit.
Vector from_centre(const Sphere& sphere, const Light& light)
{
    return light.position.w == 0 ? Vector(light.position) : Vector(light.position) - Vector(sphere.centre);
}

glm::vec3 at(const Sphere& sphere, const Vector& n) { return glm::vec3(Vector(sphere.centre) + radius_of(sphere) * n); }

}

glm::vec3 brightest_diffuse(const Sphere& sphere, const Light& light)
{
    return at(sphere, normalize(from_centre(sphere, light)));
}

bool is_seen(const Sphere& sphere, const glm::vec3& point, const glm::vec3& eye)
{
    return dot(Vector(point) - Vector(sphere.centre), Vector(eye) - Vector(point)) > 0;
}

std::optional<glm::vec3> brightest_seen(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    const Real r = radius_of(sphere);
    const Vector l = normalize(from_centre(sphere, light));
    const Vector e = Vector(eye) - Vector(sphere.centre);
    const Real d = length(e);
    const Vector to_eye = e / d;
    const Real level = r / d;
    if (dot(l, to_eye) > level) return at(sphere, l);
    const Vector flat = l - dot(l, to_eye) * to_eye;
    if (length(flat) < 1e-15L) return std::nullopt;
    const Vector n = level * to_eye + std::sqrt(1 - level * level) * normalize(flat);
    const Real lit = light.position.w == 0 ? dot(n, l) : dot(n, l) * length(from_centre(sphere, light)) - r;
    if (lit <= 0) return std::nullopt;
    return at(sphere, n);
}

std::optional<glm::vec3> brightest_specular(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    // Radii as units. In the plane: the light's direction is the x axis.
    const Real r = radius_of(sphere);
    const Vector a = from_centre(sphere, light) / r;
    const Vector b = (Vector(eye) - Vector(sphere.centre)) / r;
    const Vector x_axis = normalize(a);
    const Vector off = b - dot(b, x_axis) * x_axis;
    // What rounding leaves of nothing has no direction.
    const Vector y_axis = length(off) > 1e-15L * length(b) ? normalize(off) : Vector(0);
    const Real eye_x = dot(b, x_axis);
    const Real eye_y = dot(b, y_axis);
    const Real light_x = length(a);
    const bool is_place = light.position.w != 0;

    // How fast the way grows with the angle.
    const auto slope = [&](Real angle) {
        const Real x = std::cos(angle);
        const Real y = std::sin(angle);
        const Real to_eye = std::hypot(eye_x - x, eye_y - y);
        const Real first = is_place ? light_x * y / std::hypot(light_x - x, y) : y;
        return first + (eye_x * y - eye_y * x) / to_eye;
    };
    Real low = 0;
    Real high = std::atan2(eye_y, eye_x);
    for (int i = 0; i < 120; ++i) {
        const Real middle = (low + high) / 2;
        (slope(middle) < 0 ? low : high) = middle;
    }
    const Real x = std::cos(low);
    const Real y = std::sin(low);
    if (eye_x * x + eye_y * y <= 1 || (is_place ? light_x * x <= 1 : x <= 0)) return std::nullopt;
    return at(sphere, x * x_axis + y * y_axis);
}

}
