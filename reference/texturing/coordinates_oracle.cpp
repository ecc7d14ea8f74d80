#include <cmath>
#include <limits>
#include <numbers>
#include <umbral/texturing/coordinates.hpp>

// The same in long double, with half-angle and quotient forms instead of one call of atan2, rounded once.

namespace umbral::texturing {
namespace {

using Real = long double;
constexpr Real pi = std::numbers::pi_v<Real>;

Real hypotenuse(Real a, Real b) { return std::hypot(a, b); }

// atan2(z, x) = 2 atan(z / (r + x)) where x >= 0, and ±π - 2 atan(z / (r - x)) elsewhere, without cancellation.
Real longitude(const glm::vec3& point)
{
    const Real x = point.x;
    const Real z = point.z;
    const Real r = hypotenuse(x, z);
    if (r == 0) return 0;
    if (x >= 0) return 2 * std::atan(z / (r + x));
    return (z >= 0 ? pi : -pi) - 2 * std::atan(z / (r - x));
}

Real latitude(const glm::vec3& point)
{
    const Real flat = hypotenuse(point.x, point.z);
    if (flat == 0) return point.y > 0 ? pi / 2 : point.y < 0 ? -pi / 2 : 0;
    return std::atan(Real{point.y} / flat);
}

float part(Real angle, Real whole) { return static_cast<float>(0.5L + angle / whole); }

}

glm::vec2 planar_coordinates(const glm::vec3& point, const TexturePlane& plane)
{
    Real u = 0;
    Real v = 0;
    for (int i = 0; i < 3; ++i) {
        const Real difference = Real{point[i]} - Real{plane.origin[i]};
        u += difference * plane.u_axis[i];
        v += difference * plane.v_axis[i];
    }
    return {u, v};
}

glm::vec2 spherical_coordinates(const glm::vec3& point)
{
    return {part(longitude(point), 2 * pi), part(latitude(point), pi)};
}

glm::vec2 cylindrical_coordinates(const glm::vec3& point, float y_min, float y_max)
{
    const Real v = y_min == y_max ? 0 : (Real{point.y} - y_min) / (Real{y_max} - y_min);
    return {part(longitude(point), 2 * pi), v};
}

std::vector<glm::vec2> parametric_coordinates(int columns, int rows)
{
    const auto width = static_cast<std::size_t>(columns) + 1;
    std::vector<glm::vec2> coordinates(width * (static_cast<std::size_t>(rows) + 1));
    for (std::size_t k = 0; k < coordinates.size(); ++k)
        coordinates[k] = {static_cast<Real>(k % width) / columns, static_cast<Real>(k / width) / rows};
    return coordinates;
}

// Longitudes relative to the one that lies furthest back: no rule about 1/2, and so another way to the same numbers.
std::array<glm::vec2, 3> spherical_triangle(const std::array<glm::vec3, 3>& corners)
{
    std::array<Real, 3> u{};
    std::array<bool, 3> has_u{};
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        has_u[i] = corners[i].x != 0 || corners[i].z != 0;
        u[i] = 0.5L + longitude(corners[i]) / (2 * pi);
        if (has_u[i]) ++count;
    }
    // The corner from which all others lie less than half a turn ahead is the first.
    for (std::size_t first = 0; first < 3; ++first) {
        if (!has_u[first]) continue;
        bool is_first = true;
        std::array<Real, 3> ahead{};
        for (std::size_t i = 0; i < 3; ++i) {
            ahead[i] = u[i] - u[first] - std::floor(u[i] - u[first]);
            is_first = is_first && (!has_u[i] || ahead[i] < 0.5L);
        }
        if (!is_first) continue;
        for (std::size_t i = 0; i < 3; ++i) u[i] = u[first] + ahead[i];
        break;
    }
    Real mean = 0;
    for (std::size_t i = 0; i < 3; ++i)
        if (has_u[i]) mean += u[i] / count;
    std::array<glm::vec2, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = {has_u[i] ? u[i] : count > 0 ? mean : 0.5L, part(latitude(corners[i]), pi)};
    return result;
}

}
