#include <array>
#include <cmath>
#include <numbers>
#include <umbral/texturing/environment.hpp>

// In long double: boxes by tables of axes and signs, the panorama by arc tangents of half angles, and the ball by its
// polar angle, which is half that of the mirrored direction.

namespace umbral::texturing {
namespace {

using Real = long double;
constexpr Real pi = std::numbers::pi_v<Real>;

// For each face: the axis ahead and its sign, the axis to the right and its sign, the axis upwards and its sign.
constexpr int table[6][6] = {{0, 1, 2, 1, 1, 1},   {0, -1, 2, -1, 1, 1}, {1, 1, 0, 1, 2, 1},
                             {1, -1, 0, 1, 2, -1}, {2, 1, 0, -1, 1, 1},  {2, -1, 0, 1, 1, 1}};

// atan2 by the half angle, in (-π, π].
Real angle(Real y, Real x)
{
    const Real r = std::hypot(x, y);
    if (y == 0) return x < 0 ? pi : 0;
    return x > 0 ? 2 * std::atan(y / (r + x)) : 2 * std::atan((r - x) / y);
}

}

glm::vec3 mirrored_direction(const glm::vec3& to_eye, const glm::vec3& normal)
{
    const Real product = Real{to_eye.x} * normal.x + Real{to_eye.y} * normal.y + Real{to_eye.z} * normal.z;
    glm::vec3 result(0);
    for (int i = 0; i < 3; ++i) result[i] = static_cast<float>(2 * product * normal[i] - to_eye[i]);
    return result;
}

BoxPlace box_place(const glm::vec3& direction)
{
    int largest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::fabs(direction[axis]) > std::fabs(direction[largest])) largest = axis;
    const int face = 2 * largest + (direction[largest] > 0 ? 0 : 1);
    const int* row = table[face];
    const Real size = 2 * std::fabs(Real{direction[largest]});
    return {static_cast<BoxFace>(face),
            {0.5L + row[3] * Real{direction[row[2]]} / size, 0.5L + row[5] * Real{direction[row[4]]} / size}};
}

glm::vec3 box_direction(const BoxPlace& place)
{
    const int* row = table[static_cast<int>(place.face)];
    glm::vec3 result(0);
    result[row[0]] = static_cast<float>(row[1]);
    result[row[2]] = static_cast<float>(row[3] * (2 * Real{place.uv.x} - 1));
    result[row[4]] = static_cast<float>(row[5] * (2 * Real{place.uv.y} - 1));
    return result;
}

glm::vec2 panorama_place(const glm::vec3& direction)
{
    const Real flat = std::hypot(Real{direction.x}, Real{direction.z});
    const Real longitude = flat == 0 ? 0 : angle(direction.x, -Real{direction.z});
    return {0.5L + longitude / (2 * pi), 0.5L + angle(direction.y, flat) / pi};
}

glm::vec3 panorama_direction(glm::vec2 uv)
{
    const Real longitude = (2 * std::remainder(Real{uv.x}, Real{1}) - 1) * pi;
    const Real from_north = (1 - Real{uv.y}) * pi;
    return {std::sin(longitude) * std::sin(from_north), std::cos(from_north),
            -std::cos(longitude) * std::sin(from_north)};
}

glm::vec2 sphere_place(const glm::vec3& direction)
{
    const Real flat = std::hypot(Real{direction.x}, Real{direction.y});
    if (flat == 0) return direction.z < 0 ? glm::vec2(1, 0.5F) : glm::vec2(0.5F);
    const Real radius = std::sin(angle(flat, direction.z) / 2) / 2;
    return {0.5L + radius * direction.x / flat, 0.5L + radius * direction.y / flat};
}

glm::vec3 sphere_direction(glm::vec2 uv)
{
    const Real x = 2 * Real{uv.x} - 1;
    const Real y = 2 * Real{uv.y} - 1;
    const Real square = x * x + y * y;
    if (square >= 1) return {0, 0, -1};
    const Real z = std::sqrt(1 - square);
    return {2 * x * z, 2 * y * z, 1 - 2 * square};
}

}
