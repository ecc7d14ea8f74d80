// alternative: longitude and latitude as arguments of complex numbers, in double; poles by cases
#include <algorithm>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <umbral/texturing/coordinates.hpp>

namespace umbral::texturing {
namespace {

using std::numbers::pi;

glm::dvec2 wide_spherical(const glm::vec3& point)
{
    const std::complex<double> flat(point.x + 0.0, point.z + 0.0);
    const double longitude = flat == 0.0 ? 0 : std::arg(flat);
    const double latitude = std::arg(std::complex<double>(std::abs(flat), point.y));
    return {(longitude / pi + 1) / 2, latitude / pi + 0.5};
}

}

glm::vec2 planar_coordinates(const glm::vec3& point, const TexturePlane& plane)
{
    const glm::mat2x3 axes(plane.u_axis, plane.v_axis);
    return transpose(axes) * (point - plane.origin);
}

glm::vec2 spherical_coordinates(const glm::vec3& point) { return wide_spherical(point); }

glm::vec2 cylindrical_coordinates(const glm::vec3& point, float y_min, float y_max)
{
    const double u = wide_spherical(point).x;
    const double height = static_cast<double>(y_max) - static_cast<double>(y_min);
    if (height == 0.0) return {u, 0};
    return {u, (static_cast<double>(point.y) - static_cast<double>(y_min)) / height};
}

std::vector<glm::vec2> parametric_coordinates(int columns, int rows)
{
    if (std::min(columns, rows) < 1) throw std::invalid_argument("a grid has at least one cell");
    std::vector<glm::vec2> table;
    table.reserve(static_cast<std::size_t>(columns + 1) * static_cast<std::size_t>(rows + 1));
    for (int row = 0; row < rows + 1; ++row) {
        const float t = static_cast<float>(row) / static_cast<float>(rows);
        for (int column = 0; column < columns + 1; ++column)
            table.push_back({static_cast<float>(column) / static_cast<float>(columns), t});
    }
    return table;
}

std::array<glm::vec2, 3> spherical_triangle(const std::array<glm::vec3, 3>& corners)
{
    std::array<glm::vec2, 3> uv{};
    std::vector<std::size_t> with_longitude;
    std::vector<std::size_t> without;
    for (std::size_t i = 0; i < 3; ++i) {
        uv[i] = wide_spherical(corners[i]);
        (corners[i].x == 0 && corners[i].z == 0 ? without : with_longitude).push_back(i);
    }
    const auto crosses = [&] {
        for (const std::size_t a : with_longitude)
            for (const std::size_t b : with_longitude)
                if (uv[a].x - uv[b].x > 0.5F) return true;
        return false;
    };
    if (crosses())
        for (const std::size_t i : with_longitude)
            if (uv[i].x < 0.5F) uv[i].x += 1;
    for (const std::size_t i : without) {
        if (with_longitude.size() == 2) uv[i].x = 0.5F * (uv[with_longitude[0]].x + uv[with_longitude[1]].x);
        if (with_longitude.size() == 1) uv[i].x = uv[with_longitude[0]].x;
    }
    return uv;
}

}
