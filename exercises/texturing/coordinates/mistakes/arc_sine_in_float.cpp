// mistake: takes the arc sine of y / r, all in float
// credit: 90..98
// hint: Near a pole the arc sine of a number close to 1 has lost half its digits, and squares of large or tiny
// coordinates overflow or vanish in float. Take atan2 of y and the distance from the axis, in double or by std::hypot.
#include <cmath>
#include <stdexcept>
#include <umbral/texturing/coordinates.hpp>

namespace umbral::texturing {
namespace {

constexpr float pi = 3.14159265F;

bool on_axis(const glm::vec3& p) { return p.x == 0 && p.z == 0; }

float longitude_part(const glm::vec3& p) { return on_axis(p) ? 0.5F : 0.5F + std::atan2(p.z + 0.0F, p.x) / (2 * pi); }

}

glm::vec2 planar_coordinates(const glm::vec3& point, const TexturePlane& plane)
{
    return {dot(point - plane.origin, plane.u_axis), dot(point - plane.origin, plane.v_axis)};
}

glm::vec2 spherical_coordinates(const glm::vec3& point)
{
    const float r = length(point);
    return {longitude_part(point), r == 0 ? 0.5F : 0.5F + std::asin(point.y / r) / pi};
}

glm::vec2 cylindrical_coordinates(const glm::vec3& point, float y_min, float y_max)
{
    return {longitude_part(point), y_min == y_max ? 0 : (point.y - y_min) / (y_max - y_min)};
}

std::vector<glm::vec2> parametric_coordinates(int columns, int rows)
{
    if (columns < 1 || rows < 1) throw std::invalid_argument("no cells");
    std::vector<glm::vec2> result;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            result.emplace_back(static_cast<float>(i) / static_cast<float>(columns),
                                static_cast<float>(j) / static_cast<float>(rows));
    return result;
}

std::array<glm::vec2, 3> spherical_triangle(const std::array<glm::vec3, 3>& corners)
{
    std::array<glm::vec2, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = spherical_coordinates(corners[i]);
    const float span =
        std::max({result[0].x, result[1].x, result[2].x}) - std::min({result[0].x, result[1].x, result[2].x});
    float sum = 0;
    float count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (on_axis(corners[i])) continue;
        if (span > 0.5F && result[i].x < 0.5F) result[i].x += 1;
        sum += result[i].x;
        count += 1;
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (on_axis(corners[i]) && count > 0) result[i].x = sum / count;
    return result;
}

}
