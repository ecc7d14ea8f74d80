// alternative: stretch by stretch, with sine and cosine of the angle in long double; the last copy is copied
#include <umbral/meshes/revolution.hpp>

namespace umbral::meshes {
namespace {

struct Point {
    double x, y;
    double before = 0;  // length up to here
    double normal_x = 0, normal_y = 0;
};

std::vector<Point> points_of(std::span<const glm::vec2> profile)
{
    std::vector<Point> points;
    for (const glm::vec2& place : profile) {
        if (!(place.x >= 0) || !std::isfinite(place.x) || !std::isfinite(place.y))
            throw std::invalid_argument("a profile on the right of the axis was expected");
        points.push_back({static_cast<double>(place.x), static_cast<double>(place.y)});
    }
    long double sum = 0;
    for (std::size_t j = 1; j < points.size(); ++j) {
        const double dx = points[j].x - points[j - 1].x;
        const double dy = points[j].y - points[j - 1].y;
        const double size = std::hypot(dx, dy);
        sum += size;
        points[j].before = static_cast<double>(sum);
        if (size == 0) continue;
        for (const std::size_t k : {j - 1, j}) {
            points[k].normal_x += dy / size;
            points[k].normal_y -= dx / size;
        }
    }
    for (Point& p : points) {
        if (p.x == 0) p.normal_x = 0;
        const double size = std::hypot(p.normal_x, p.normal_y);
        p.normal_x = size < 1e-6 ? 0 : p.normal_x / size;
        p.normal_y = size < 1e-6 ? 0 : p.normal_y / size;
    }
    return points;
}

}

TexturedMesh revolve(std::span<const glm::vec2> profile, std::uint32_t copies)
{
    if (profile.size() < 2 || copies < 4) throw std::invalid_argument("two points and four copies were expected");
    const std::vector<Point> points = points_of(profile);
    if (points.back().before == 0) throw std::invalid_argument("a profile of some length was expected");
    TexturedMesh result;
    const std::size_t row = points.size();
    for (std::uint32_t i = 0; i + 1 < copies; ++i) {
        const long double angle = 6.283185307179586476925L * i / (copies - 1);
        const auto c = static_cast<double>(std::cos(angle));
        const auto s = static_cast<double>(std::sin(angle));
        for (const Point& p : points) {
            result.mesh.positions.emplace_back(p.x * c, p.y, -p.x * s);
            result.normals.emplace_back(p.normal_x * c, p.normal_y, -p.normal_x * s);
            result.texture_coordinates.emplace_back(static_cast<double>(i) / (copies - 1),
                                                    p.before / points.back().before);
        }
    }
    for (std::size_t j = 0; j < row; ++j) {
        result.mesh.positions.push_back(glm::vec3(result.mesh.positions[j]));
        result.normals.push_back(glm::vec3(result.normals[j]));
        result.texture_coordinates.emplace_back(1, result.texture_coordinates[j].y);
    }
    for (std::size_t j = 1; j < row; ++j) {
        const bool is_flat = points[j].x == points[j - 1].x && points[j].y == points[j - 1].y;
        for (std::uint32_t i = 1; i < copies && !is_flat; ++i) {
            const auto high = static_cast<std::uint32_t>(i * row + j);
            const auto before = static_cast<std::uint32_t>(high - row);
            if (points[j - 1].x > 0) result.mesh.triangles.emplace_back(before - 1, high - 1, high);
            if (points[j].x > 0) result.mesh.triangles.emplace_back(high, before, before - 1);
        }
    }
    return result;
}

}
