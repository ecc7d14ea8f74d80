// alternative: everything in float, with std::hypot and halved heights; longitudes counted from the first corner
#include <cmath>
#include <stdexcept>
#include <umbral/texturing/coordinates.hpp>

namespace umbral::texturing {
namespace {

constexpr float pi = 3.14159265F;

bool has_longitude(const glm::vec3& p) { return p.x != 0 || p.z != 0; }

}

glm::vec2 planar_coordinates(const glm::vec3& point, const TexturePlane& plane)
{
    const glm::vec3 offset = point - plane.origin;
    return glm::vec2(dot(plane.u_axis, offset), dot(plane.v_axis, offset));
}

glm::vec2 spherical_coordinates(const glm::vec3& point)
{
    const float z = point.z == 0 ? 0 : point.z;
    const float alpha = has_longitude(point) ? std::atan2(z, point.x) : 0;
    const float beta = std::atan2(point.y, std::hypot(point.x, point.z));
    return {(alpha + pi) / (2 * pi), (beta + pi / 2) / pi};
}

glm::vec2 cylindrical_coordinates(const glm::vec3& point, float y_min, float y_max)
{
    const float u = spherical_coordinates({point.x, 0, point.z}).x;
    if (y_min == y_max) return {u, 0};
    return {u, (point.y / 2 - y_min / 2) / (y_max / 2 - y_min / 2)};
}

std::vector<glm::vec2> parametric_coordinates(int columns, int rows)
{
    if (columns <= 0) throw std::invalid_argument("columns");
    if (rows <= 0) throw std::invalid_argument("rows");
    std::vector<glm::vec2> table(static_cast<std::size_t>((columns + 1) * (rows + 1)));
    const float ds = 1.0F / static_cast<float>(columns);
    const float dt = 1.0F / static_cast<float>(rows);
    for (std::size_t k = 0; k < table.size(); ++k) {
        const int i = static_cast<int>(k) % (columns + 1);
        const int j = static_cast<int>(k) / (columns + 1);
        table[k] = {static_cast<float>(i) * ds, static_cast<float>(j) * dt};
    }
    return table;
}

std::array<glm::vec2, 3> spherical_triangle(const std::array<glm::vec3, 3>& corners)
{
    std::array<glm::vec2, 3> uv{};
    std::array<bool, 3> has{};
    int first = -1;
    for (int i = 2; i >= 0; --i) {
        const auto k = static_cast<std::size_t>(i);
        uv[k] = spherical_coordinates(corners[k]);
        has[k] = has_longitude(corners[k]);
        if (has[k]) first = i;
    }
    if (first < 0) return uv;

    // Each within half a turn of the first one; then all on, if one of them had to go back across the seam.
    const float start = uv[static_cast<std::size_t>(first)].x;
    bool moved_back = false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!has[i]) continue;
        if (uv[i].x - start < -0.5F) uv[i].x += 1;
        if (uv[i].x - start > 0.5F) {
            uv[i].x -= 1;
            moved_back = true;
        }
    }
    float sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!has[i]) continue;
        if (moved_back) uv[i].x += 1;
        sum += uv[i].x;
        ++count;
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (!has[i]) uv[i].x = sum / static_cast<float>(count);
    return uv;
}

}
