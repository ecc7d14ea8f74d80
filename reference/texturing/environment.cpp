// Based on: J. Blinn, M. Newell. Texture and Reflection in Computer Generated Images. CACM 19(10), 1976 (panorama);
// N. Greene. Environment Mapping and Other Applications of World Projections. IEEE CG&A 6(11), 1986 (box).

#include <cmath>
#include <numbers>
#include <umbral/texturing/environment.hpp>

namespace umbral::texturing {
namespace {

using std::numbers::pi;

// A face as seen from inside: ahead, to the right and upwards.
struct Axes {
    glm::dvec3 ahead, right, up;
};

Axes axes_of(BoxFace face)
{
    constexpr glm::dvec3 x(1, 0, 0);
    constexpr glm::dvec3 y(0, 1, 0);
    constexpr glm::dvec3 z(0, 0, 1);
    switch (face) {
        case BoxFace::right: return {x, z, y};
        case BoxFace::left: return {-x, -z, y};
        case BoxFace::top: return {y, x, z};
        case BoxFace::bottom: return {-y, x, -z};
        case BoxFace::back: return {z, -x, y};
        case BoxFace::front: break;
    }
    return {-z, x, y};
}

BoxFace face_towards(const glm::vec3& direction)
{
    const glm::vec3 size = abs(direction);
    if (size.x >= size.y && size.x >= size.z) return direction.x > 0 ? BoxFace::right : BoxFace::left;
    if (size.y >= size.z) return direction.y > 0 ? BoxFace::top : BoxFace::bottom;
    return direction.z > 0 ? BoxFace::back : BoxFace::front;
}

}

glm::vec3 mirrored_direction(const glm::vec3& to_eye, const glm::vec3& normal)
{
    const glm::dvec3 v(to_eye);
    const glm::dvec3 n(normal);
    return 2 * dot(n, v) * n - v;
}

BoxPlace box_place(const glm::vec3& direction)
{
    const BoxFace face = face_towards(direction);
    const Axes axes = axes_of(face);
    const glm::dvec3 d(direction);
    const double depth = 2 * dot(d, axes.ahead);
    return {face, {0.5 + dot(d, axes.right) / depth, 0.5 + dot(d, axes.up) / depth}};
}

glm::vec3 box_direction(const BoxPlace& place)
{
    const Axes axes = axes_of(place.face);
    return axes.ahead + (2.0 * place.uv.x - 1) * axes.right + (2.0 * place.uv.y - 1) * axes.up;
}

glm::vec2 panorama_place(const glm::vec3& direction)
{
    const glm::dvec3 d(direction);
    const double flat = std::sqrt(d.x * d.x + d.z * d.z);
    // Adding 0 turns -0 into 0, whose angle is π and not -π.
    const double longitude = flat == 0 ? 0 : std::atan2(d.x + 0.0, -d.z);
    return {0.5 + longitude / (2 * pi), 0.5 + std::atan2(d.y, flat) / pi};
}

glm::vec3 panorama_direction(glm::vec2 uv)
{
    // Whole turns go first, exactly: a sine of many of them is off by what pi is.
    const double longitude = (std::remainder(double{uv.x}, 1.0) - 0.5) * 2 * pi;
    const double latitude = (double{uv.y} - 0.5) * pi;
    return {std::sin(longitude) * std::cos(latitude), std::sin(latitude), -std::cos(longitude) * std::cos(latitude)};
}

glm::vec2 sphere_place(const glm::vec3& direction)
{
    const glm::dvec3 r = normalize(glm::dvec3(direction));
    if (r.x == 0 && r.y == 0 && r.z < 0) return {1, 0.5};
    const glm::dvec3 n = normalize(r + glm::dvec3(0, 0, 1));
    return {0.5 + n.x / 2, 0.5 + n.y / 2};
}

glm::vec3 sphere_direction(glm::vec2 uv)
{
    const glm::dvec2 flat = 2.0 * glm::dvec2(uv) - 1.0;
    const double square = dot(flat, flat);
    if (square >= 1) return {0, 0, -1};
    const double z = std::sqrt(1 - square);
    return 2 * z * glm::dvec3(flat, z) - glm::dvec3(0, 0, 1);
}

}
