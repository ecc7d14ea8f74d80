// mistake: float throughout
// credit: 70..95
// hint: If up is almost parallel to the normal, u × n subtracts products that agree in nearly all their digits; and
// many turns leave a float few digits for the angle. Compute in double.
#include <umbral/projections/view_frame.hpp>

namespace umbral::projections {

std::optional<ViewFrame> view_frame(const ViewParameters& view)
{
    if (length(view.normal) == 0 || length(view.up) == 0) return std::nullopt;
    const glm::vec3 z = normalize(view.normal);
    const glm::vec3 side = cross(normalize(view.up), z);
    if (length(side) < 1e-6F) return std::nullopt;
    const glm::vec3 x = normalize(side);
    return ViewFrame{x, cross(z, x), z, view.target + view.normal};
}

ViewParameters view_from(const glm::vec3& target, float distance, float azimuth_degrees, float elevation_degrees,
                         float roll_degrees)
{
    const float a = glm::radians(azimuth_degrees);
    const float b = glm::radians(elevation_degrees);
    const float r = glm::radians(roll_degrees);
    const glm::vec3 x(std::cos(a), 0, -std::sin(a));
    const glm::vec3 z(std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a));
    return {target, std::cos(r) * cross(z, x) + std::sin(r) * x, distance * z};
}

}
