#include <umbral/projections/curved.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "wide_vector.hpp"

// Lengths in 113 bits, angles with at least 64, rounded to float once. Angles between vectors by half angles, and each
// triangle is cut by itself, along its barycentric coordinates, as often as a first pass over all has found.

namespace umbral::projections {
namespace {

// 2 atan2(|u - v|, |u + v|) for the unit vectors u, v (W. Kahan).
long double angle_between(const glm::vec3& a, const glm::vec3& b)
{
    const Wide la = length(widened(a));
    const Wide lb = length(widened(b));
    if (la == 0 || lb == 0) return 0;
    const WideVector u = widened(a) / la;
    const WideVector v = widened(b) / lb;
    return 2 * std::atan2(static_cast<long double>(length(u - v)), static_cast<long double>(length(u + v)));
}

/// The point of a triangle at (i, j) of its grid of so many parts a side, in the arithmetic of repeated halving, which
/// is exact for whole coordinates.
glm::vec3 point_of(std::span<const glm::vec3> t, int i, int j, int parts)
{
    return rounded((Wide(parts - i - j) * widened(t[0]) + Wide(i) * widened(t[1]) + Wide(j) * widened(t[2])) /
                   Wide(parts));
}

std::vector<glm::vec3> cut(std::span<const glm::vec3> corners, int parts)
{
    std::vector<glm::vec3> result;
    for (std::size_t first = 0; first < corners.size(); first += 3) {
        const auto at = [&](int i, int j) { return point_of(corners.subspan(first, 3), i, j, parts); };
        for (int i = 0; i < parts; ++i)
            for (int j = 0; i + j < parts; ++j) {
                result.insert(result.end(), {at(i, j), at(i + 1, j), at(i, j + 1)});
                if (i + j + 1 < parts) result.insert(result.end(), {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
    }
    return result;
}

}

std::optional<CurvedPoint> spherical_projection(const glm::vec3& point)
{
    const Wide distance = length(widened(point));
    if (distance == 0 || point.z > 0) return std::nullopt;
    return CurvedPoint{{static_cast<float>(point.x / distance), static_cast<float>(point.y / distance)},
                       static_cast<float>(distance)};
}

std::optional<CurvedPoint> cylindrical_projection(const glm::vec3& point)
{
    const Wide from_axis = length(WideVector{point.x, 0, point.z});
    if (from_axis == 0) return std::nullopt;
    long double angle = std::atan2(static_cast<long double>(point.x), -static_cast<long double>(point.z));
    if (point.x == 0 && point.z > 0) angle = std::numbers::pi_v<long double>;
    return CurvedPoint{{static_cast<float>(angle), static_cast<float>(point.y / from_axis)},
                       static_cast<float>(length(widened(point)))};
}

float visual_angle(const glm::vec3& a, const glm::vec3& b) { return static_cast<float>(angle_between(a, b)); }

std::vector<glm::vec3> tessellated(std::span<const glm::vec3> corners, float largest_angle)
{
    if (corners.size() % 3 != 0) throw std::invalid_argument("corners");
    if (!(largest_angle > 0)) throw std::invalid_argument("largest_angle");
    std::vector<glm::vec3> triangles(corners.begin(), corners.end());
    for (int parts = 1;; parts *= 2) {
        triangles = cut(corners, parts);
        long double widest = 0;
        for (std::size_t i = 0; i < triangles.size(); i += 3)
            for (std::size_t side = 0; side < 3; ++side)
                widest = std::max(widest, angle_between(triangles[i + side], triangles[i + (side + 1) % 3]));
        if (widest <= largest_angle || parts == 64) return triangles;
    }
}

std::array<float, 3> without_seam(const std::array<float, 3>& angles)
{
    constexpr long double turn = 2 * std::numbers::pi_v<long double>;
    std::array<float, 3> moved{};
    for (std::size_t i = 0; i < 3; ++i)
        moved[i] = static_cast<float>(angles[i] - turn * std::nearbyint((angles[i] - (long double){angles[0]}) / turn));
    return moved;
}

}
