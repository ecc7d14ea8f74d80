// Based on: the course's view frame (z = n/|n|, x = u×n/|u×n|, y = z×x); problems 3.1, 3.2 and 3.3.

#include <umbral/projections/view_frame.hpp>

#include <cmath>
#include <numbers>

namespace umbral::projections {

// In double: u×n subtracts products that agree in nearly all digits if u is almost parallel to n.
std::optional<ViewFrame> view_frame(const ViewParameters& view)
{
    const glm::dvec3 n(view.normal);
    const glm::dvec3 u(view.up);
    const glm::dvec3 side = cross(u, n);

    // |u×n| = |u| |n| sin α. Lengths of floats, and their products, are in the range of double.
    constexpr double smallest_sine = 1e-6;
    const double size = length(u) * length(n);
    if (size == 0 || length(side) < smallest_sine * size) return std::nullopt;

    const glm::dvec3 z = normalize(n);
    const glm::dvec3 x = normalize(side);
    return ViewFrame{glm::vec3(x), glm::vec3(cross(z, x)), glm::vec3(z), view.target + view.normal};
}

ViewParameters view_from(const glm::vec3& target, float distance, float azimuth_degrees, float elevation_degrees,
                         float roll_degrees)
{
    constexpr double degree = std::numbers::pi / 180;
    const double azimuth = azimuth_degrees * degree;
    const double elevation = elevation_degrees * degree;
    const double roll = roll_degrees * degree;

    // The camera's axes before it rolls. They have no division in them, so they exist above the target too.
    const glm::dvec3 x(std::cos(azimuth), 0, -std::sin(azimuth));
    const glm::dvec3 z(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                       std::cos(elevation) * std::cos(azimuth));
    const glm::dvec3 y = cross(z, x);

    // The world appears turned anticlockwise, so the camera turns clockwise: its y axis towards its x axis.
    const glm::dvec3 up = std::cos(roll) * y + std::sin(roll) * x;
    return {target, glm::vec3(up), glm::vec3(double{distance} * z)};
}

}
