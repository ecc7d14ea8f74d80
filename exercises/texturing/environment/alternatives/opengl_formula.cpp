// alternative: OpenGL's formula for spherical maps, a table of matrices for the box, and an arc sine in double
#include <algorithm>
#include <cmath>
#include <numbers>
#include <umbral/texturing/environment.hpp>

namespace umbral::texturing {
namespace {

using std::numbers::pi;

// Rows: to the right, upwards, ahead.
const glm::mat3 faces[] = {{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},  {{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}},
                           {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},  {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                           {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}};

}

glm::vec3 mirrored_direction(const glm::vec3& to_eye, const glm::vec3& normal)
{
    const glm::vec3 along = dot(to_eye, normal) * normal;
    return along - (to_eye - along);
}

BoxPlace box_place(const glm::vec3& direction)
{
    int best = 0;
    for (int face = 1; face < 6; ++face)
        if (dot(direction, faces[face][2]) > dot(direction, faces[best][2])) best = face;
    // Equal ones: the first axis has won, since the comparison is strict.
    const glm::dvec3 seen = glm::dvec3(direction) * glm::dmat3(faces[best]);
    return {static_cast<BoxFace>(best), {(seen.x / seen.z + 1) / 2, (seen.y / seen.z + 1) / 2}};
}

glm::vec3 box_direction(const BoxPlace& place)
{
    return faces[static_cast<int>(place.face)] * glm::vec3(2.0F * place.uv - 1.0F, 1);
}

glm::vec2 panorama_place(const glm::vec3& direction)
{
    const glm::dvec3 unit = normalize(glm::dvec3(direction));
    double longitude = 0;
    if (unit.x != 0 || unit.z != 0) longitude = std::atan2(unit.x, -unit.z);
    if (longitude == -pi) longitude = pi;
    return {longitude / (2 * pi) + 0.5, std::asin(std::clamp(unit.y, -1.0, 1.0)) / pi + 0.5};
}

glm::vec3 panorama_direction(glm::vec2 uv)
{
    const double around = uv.x * 2 * pi;  // from behind
    const double down = (1 - uv.y) * pi;
    return {-std::sin(around) * std::sin(down), std::cos(down), std::cos(around) * std::sin(down)};
}

glm::vec2 sphere_place(const glm::vec3& direction)
{
    const glm::dvec3 r = normalize(glm::dvec3(direction));
    const double m = 2 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1));
    if (m == 0) return {1, 0.5};
    return {r.x / m + 0.5, r.y / m + 0.5};
}

glm::vec3 sphere_direction(glm::vec2 uv)
{
    const glm::dvec2 p = glm::dvec2(uv) * 2.0 - 1.0;
    const glm::dvec3 n(p, std::sqrt(std::max(0.0, 1 - dot(p, p))));
    if (n.z == 0) return {0, 0, -1};
    return -reflect(glm::dvec3(0, 0, 1), n);
}

}
