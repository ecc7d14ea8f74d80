// Based on: the course's spherical and cylindrical projections; R. Szeliski. Computer Vision: Algorithms and
// Applications. 2010, 9.1.6 (cylindrical and spherical coordinates); W. Kahan. How futile are mindless assessments of
// roundoff in floating-point computation? 2006, 12 (angles between vectors).

#include <umbral/projections/curved.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace umbral::projections {
namespace {

constexpr int most_times = 6;

double angle_between(const glm::vec3& a, const glm::vec3& b)
{
    const glm::dvec3 from(a);
    const glm::dvec3 to(b);
    // Their product may be -0 there, and atan2(0, -0) is π.
    if (from == glm::dvec3(0) || to == glm::dvec3(0)) return 0;
    return std::atan2(length(cross(from, to)), dot(from, to));
}

/// Does the eye see an edge of a triangle under more than this angle?
bool is_coarse(std::span<const glm::vec3> corners, float largest_angle)
{
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        if (angle_between(corners[i], corners[next]) > largest_angle) return true;
    }
    return false;
}

std::vector<glm::vec3> cut_in_four(std::span<const glm::vec3> corners)
{
    std::vector<glm::vec3> finer;
    finer.reserve(4 * corners.size());
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const glm::vec3& a = corners[i];
        const glm::vec3& b = corners[i + 1];
        const glm::vec3& c = corners[i + 2];
        const glm::vec3 ab = 0.5F * (a + b);
        const glm::vec3 bc = 0.5F * (b + c);
        const glm::vec3 ca = 0.5F * (c + a);
        finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    return finer;
}

}

// In double: squares of floats neither overflow nor vanish there.
std::optional<CurvedPoint> spherical_projection(const glm::vec3& point)
{
    const glm::dvec3 p(point);
    const double distance = length(p);
    if (p.z > 0 || distance == 0) return std::nullopt;
    return CurvedPoint{glm::vec2(glm::dvec2(p) / distance), static_cast<float>(distance)};
}

std::optional<CurvedPoint> cylindrical_projection(const glm::vec3& point)
{
    const glm::dvec3 p(point);
    const double from_axis = length(glm::dvec2(p.x, p.z));
    if (from_axis == 0) return std::nullopt;
    // A zero without sign, so that what lies straight behind is at π.
    const double angle = p.x == 0 && p.z > 0 ? std::numbers::pi : std::atan2(p.x, -p.z);
    return CurvedPoint{glm::vec2(angle, p.y / from_axis), static_cast<float>(length(p))};
}

float visual_angle(const glm::vec3& a, const glm::vec3& b) { return static_cast<float>(angle_between(a, b)); }

std::vector<glm::vec3> tessellated(std::span<const glm::vec3> corners, float largest_angle)
{
    if (corners.size() % 3 != 0) throw std::invalid_argument("triangles have three corners each");
    if (!(largest_angle > 0)) throw std::invalid_argument("the largest angle must be more than 0");
    std::vector<glm::vec3> triangles(corners.begin(), corners.end());
    for (int times = 0; times < most_times && is_coarse(triangles, largest_angle); ++times)
        triangles = cut_in_four(triangles);
    return triangles;
}

std::array<float, 3> without_seam(const std::array<float, 3>& angles)
{
    constexpr double turn = 2 * std::numbers::pi;
    std::array<float, 3> moved = angles;
    for (std::size_t i = 1; i < 3; ++i) {
        const double aside = double{angles[i]} - angles[0];
        if (aside > std::numbers::pi) moved[i] = static_cast<float>(angles[i] - turn);
        if (aside < -std::numbers::pi) moved[i] = static_cast<float>(angles[i] + turn);
    }
    return moved;
}

}
