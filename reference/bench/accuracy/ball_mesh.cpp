#include "ball_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace umbral::bench {
namespace {

constexpr double pi = 3.141592653589793;

/// The smallest distance from the origin to a segment or a triangle.
double distance_to_segment(const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 along = b - a;
    const double t = std::clamp(-dot(a, along) / dot(along, along), 0.0, 1.0);
    return length(a + t * along);
}

double distance_to_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& normal)
{
    const double height = dot(a, normal);
    const glm::dvec3 foot = height * normal;
    const auto inside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return dot(cross(to - from, foot - from), normal) >= 0;
    };
    if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(height);
    return std::min({distance_to_segment(a, b), distance_to_segment(b, c), distance_to_segment(c, a)});
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Based on: A. M. Andrew. Another efficient algorithm for convex hulls in two dimensions. 1979.
std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points)
{
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<glm::dvec2> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t start = hull.size();
        for (const glm::dvec2& point : points) {
            while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// The outline of the sphere is the unit circle; that of a convex mesh is the hull of its corners, and deviates most in
/// the middle of a side.
double outline_error(const BallMesh& mesh, const glm::dvec3& towards)
{
    const glm::dvec3 right =
        normalize(cross(towards, std::abs(towards.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
    const glm::dvec3 up = cross(right, towards);
    std::vector<glm::dvec2> points;
    for (const glm::vec3& position : mesh.positions)
        points.emplace_back(dot(glm::dvec3(position), right), dot(glm::dvec3(position), up));
    const std::vector<glm::dvec2> hull = convex_hull(std::move(points));
    double least = 1;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2& next = hull[(i + 1) % hull.size()];
        least = std::min(least, distance_to_segment({hull[i], 0}, {next, 0}));
    }
    return 1 - least;
}

}

BallMesh ball_mesh(int sectors, int rings)
{
    BallMesh mesh;
    const auto place = [](double latitude, double longitude) {
        return glm::vec3(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                         std::sin(latitude));
    };
    mesh.positions.emplace_back(0, 0, -1);
    for (int ring = 1; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector)
            mesh.positions.push_back(place(pi * (double(ring) / rings - 0.5), 2 * pi * sector / sectors));
    mesh.positions.emplace_back(0, 0, 1);
    const auto corner = [&](int ring, int sector) {
        if (ring == 0) return std::uint32_t{0};
        if (ring == rings) return static_cast<std::uint32_t>(mesh.positions.size() - 1);
        return static_cast<std::uint32_t>(1 + (ring - 1) * sectors + sector % sectors);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int sector = 0; sector < sectors; ++sector) {
            const std::uint32_t a = corner(ring, sector);
            const std::uint32_t b = corner(ring, sector + 1);
            const std::uint32_t c = corner(ring + 1, sector + 1);
            const std::uint32_t d = corner(ring + 1, sector);
            // At a pole one of the two triangles has no area.
            if (a != b) mesh.indices.insert(mesh.indices.end(), {a, b, c});
            if (c != d) mesh.indices.insert(mesh.indices.end(), {a, c, d});
        }
    }
    return mesh;
}

BallErrors errors_of(const BallMesh& mesh, const glm::dvec3& towards)
{
    double nearest = 1;
    double least_cosine = 1;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
        const glm::dvec3 normal = normalize(cross(b - a, c - a));
        nearest = std::min(nearest, distance_to_triangle(a, b, c, normal));
        // The directions of a facet's points lie between those of its corners, so that the angle is largest at one of
        // them.
        for (const glm::dvec3& corner : {a, b, c})
            least_cosine = std::min(least_cosine, dot(normal, normalize(corner)));
    }
    return {1 - nearest, std::acos(std::clamp(least_cosine, -1.0, 1.0)), outline_error(mesh, towards)};
}

}
