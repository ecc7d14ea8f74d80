// Based on: the course's oblique parallel projection; J. Foley, A. van Dam, S. Feiner, J. Hughes. Computer Graphics:
// Principles and Practice. 1990, 6.1 and 6.5.

#include <umbral/projections/oblique.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace umbral::projections {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Where in the picture a point appears that lies one unit farther than the view plane.
glm::dvec2 shift_of(const Lean& lean)
{
    // Whole turns are taken off in degrees, which is exact: in radians they would be rounded.
    const double angle = std::remainder(double{lean.angle_degrees}, 360.0) * degree;
    return double{lean.foreshortening} * glm::dvec2(std::cos(angle), std::sin(angle));
}

}

// The cotangent; near 90° as the tangent of the angle that is left, a difference that is exact there and no longer is
// for small angles.
float foreshortening_of(float alpha_degrees)
{
    if (!(alpha_degrees > 0 && alpha_degrees <= 90))
        throw std::invalid_argument("rays meet the view plane at an angle of more than 0 and at most 90 degrees");
    if (alpha_degrees < 45) return static_cast<float>(1 / std::tan(alpha_degrees * degree));
    return static_cast<float>(std::tan((90.0 - alpha_degrees) * degree));
}

glm::mat4 oblique_shear(const Lean& lean)
{
    const glm::dvec2 shift = shift_of(lean);
    glm::mat4 matrix(1);
    matrix[2] = {-shift.x, -shift.y, 1, 0};
    return matrix;
}

glm::mat4 oblique_matrix(const ViewVolume& box, const Lean& lean)
{
    const glm::dvec2 shift = shift_of(lean);
    const glm::dvec3 from(box.left, box.bottom, -double{box.near_plane});
    const glm::dvec3 to(box.right, box.top, -double{box.far_plane});
    const glm::dvec3 scale = 2.0 / (to - from);
    const glm::dvec3 offset = -(to + from) / (to - from);
    return {{scale.x, 0, 0, 0},
            {0, scale.y, 0, 0},
            {-shift.x * scale.x, -shift.y * scale.y, scale.z, 0},
            {offset.x, offset.y, offset.z, 1}};
}

// What the shear takes to the -z axis.
glm::vec3 projector_direction(const Lean& lean) { return glm::vec3(normalize(glm::dvec3(-shift_of(lean), -1))); }

}
