// alternative: std::hypot in float, angles by W. Kahan's formula in double, recursion instead of passes, std::remainder
#include <numbers>
#include <stdexcept>
#include <umbral/projections/curved.hpp>

namespace umbral::projections {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

glm::vec3 middle(const glm::vec3& a, const glm::vec3& b) { return a / 2.0F + b / 2.0F; }

double angle(const glm::dvec3& a, const glm::dvec3& b)
{
    const double la = glm::length(a);
    const double lb = glm::length(b);
    if (la == 0 || lb == 0) return 0;
    return 2 * std::atan2(glm::length(a / la - b / lb), glm::length(a / la + b / lb));
}

/// Adds a triangle that is cut `times` times; returns the widest angle of an edge.
double add(std::vector<glm::vec3>& list, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, int times)
{
    if (times == 0) {
        for (const glm::vec3& corner : {a, b, c}) list.push_back(corner);
        return std::max({angle(a, b), angle(b, c), angle(c, a)});
    }
    const glm::vec3 ab = middle(a, b);
    const glm::vec3 bc = middle(b, c);
    const glm::vec3 ca = middle(c, a);
    return std::max({add(list, ab, bc, ca, times - 1), add(list, a, ab, ca, times - 1), add(list, b, bc, ab, times - 1),
                     add(list, c, ca, bc, times - 1)});
}

}

std::optional<CurvedPoint> spherical_projection(const glm::vec3& point)
{
    const float d = std::hypot(point.x, point.y, point.z);
    if (!(d > 0) || point.z > 0) return {};
    return CurvedPoint{{point.x / d, point.y / d}, d};
}

std::optional<CurvedPoint> cylindrical_projection(const glm::vec3& point)
{
    if (point.x == 0 && point.z == 0) return std::nullopt;
    float theta = std::atan2(point.x, -point.z);
    if (point.x == 0) theta = std::abs(theta);
    const float radius = std::hypot(point.x, point.z);
    return CurvedPoint{{theta, point.y / radius}, std::hypot(radius, point.y)};
}

float visual_angle(const glm::vec3& a, const glm::vec3& b) { return static_cast<float>(angle(a, b)); }

std::vector<glm::vec3> tessellated(std::span<const glm::vec3> corners, float largest_angle)
{
    const bool valid = corners.size() % 3 == 0 && largest_angle > 0;
    if (!valid) throw std::invalid_argument("tessellated");
    for (int times = 0;; ++times) {
        std::vector<glm::vec3> list;
        double widest = 0;
        for (std::size_t i = 0; i < corners.size(); i += 3)
            widest = std::max(widest, add(list, corners[i], corners[i + 1], corners[i + 2], times));
        if (widest <= largest_angle || times == 6) return list;
    }
}

std::array<float, 3> without_seam(const std::array<float, 3>& angles)
{
    const auto near_first = [&](float angle) { return angles[0] + std::remainder(angle - angles[0], 2 * pi); };
    return {angles[0], near_first(angles[1]), near_first(angles[2])};
}

}
