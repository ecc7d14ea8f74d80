// Based on: E. Bier, K. Sloan. Two-Part Texture Mappings. IEEE Computer Graphics and Applications 6(9), 1986 (plane,
// cylinder and sphere as intermediate surfaces).

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <umbral/texturing/coordinates.hpp>

namespace umbral::texturing {
namespace {

using std::numbers::pi;

bool on_axis(const glm::vec3& point) { return point.x == 0 && point.z == 0; }

// Longitude as a part of a turn, in [0, 1]. Adding 0 turns -0 into 0, whose angle is π and not -π.
double around(const glm::vec3& point)
{
    if (on_axis(point)) return 0.5;
    return 0.5 + std::atan2(double{point.z} + 0.0, double{point.x}) / (2 * pi);
}

// Latitude as a part of half a turn. In double no square of a float overflows or vanishes.
double upwards(const glm::vec3& point)
{
    const glm::dvec3 p(point);
    return 0.5 + std::atan2(p.y, std::sqrt(p.x * p.x + p.z * p.z)) / pi;
}

}

glm::vec2 planar_coordinates(const glm::vec3& point, const TexturePlane& plane)
{
    // The difference first: far from the world's origin, two large products would cancel.
    const glm::dvec3 from_origin = glm::dvec3(point) - glm::dvec3(plane.origin);
    return {dot(from_origin, glm::dvec3(plane.u_axis)), dot(from_origin, glm::dvec3(plane.v_axis))};
}

glm::vec2 spherical_coordinates(const glm::vec3& point) { return {around(point), upwards(point)}; }

glm::vec2 cylindrical_coordinates(const glm::vec3& point, float y_min, float y_max)
{
    const double height = double{y_max} - y_min;
    return {around(point), height == 0 ? 0 : (double{point.y} - y_min) / height};
}

std::vector<glm::vec2> parametric_coordinates(int columns, int rows)
{
    if (columns < 1 || rows < 1)
        throw std::invalid_argument("parametric_coordinates: expected a grid of at least 1 x 1 cells, got " +
                                    std::to_string(columns) + " x " + std::to_string(rows));
    std::vector<glm::vec2> coordinates;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            coordinates.emplace_back(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
    return coordinates;
}

std::array<glm::vec2, 3> spherical_triangle(const std::array<glm::vec3, 3>& corners)
{
    std::array<glm::vec2, 3> result{};
    float least = 1;
    float largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = spherical_coordinates(corners[i]);  // 1/2 on the axis, which changes nothing below
        least = std::min(least, result[i].x);
        largest = std::max(largest, result[i].x);
    }
    const bool crosses_seam = largest - least > 0.5F;

    float sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (on_axis(corners[i])) continue;
        if (crosses_seam && result[i].x < 0.5F) result[i].x += 1;
        sum += result[i].x;
        ++count;
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (on_axis(corners[i]) && count > 0) result[i].x = sum / static_cast<float>(count);
    return result;
}

}
