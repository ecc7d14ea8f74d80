#include <umbral/projections/curved.hpp>

namespace umbral::projections {

std::optional<CurvedPoint> spherical_projection(const glm::vec3& point)
{
    // TODO: move the point along its ray until it is at distance 1. Which points have no place?
    return not_implemented<std::optional<CurvedPoint>>(point);
}

std::optional<CurvedPoint> cylindrical_projection(const glm::vec3& point)
{
    // TODO: the angle about the y axis, and the height at distance 1 from that axis.
    return not_implemented<std::optional<CurvedPoint>>(point);
}

float visual_angle(const glm::vec3& a, const glm::vec3& b)
{
    // TODO: the angle between two directions, also where it is tiny.
    return not_implemented<float>(a, b);
}

std::vector<glm::vec3> tessellated(std::span<const glm::vec3> corners, float largest_angle)
{
    // TODO: while any edge is too long for the eye, cut every triangle in four.
    return not_implemented<std::vector<glm::vec3>>(corners, largest_angle);
}

std::array<float, 3> without_seam(const std::array<float, 3>& angles)
{
    // TODO: an angle and the same angle a whole turn further are one direction. Which of them is near the first?
    return not_implemented<std::array<float, 3>>(angles);
}

}
