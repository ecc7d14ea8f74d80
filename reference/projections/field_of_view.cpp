// Based on: the course's MAT_Perspectiva (gluPerspective); N. Reed. Depth precision visualized. 2015.

#include <umbral/projections/perspective.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace umbral::projections {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Written so that NaN is refused too.
void require_angle(float degrees, float aspect)
{
    if (!(degrees > 0 && degrees < 180)) throw std::invalid_argument("a field of view lies between 0 and 180 degrees");
    if (!(aspect > 0)) throw std::invalid_argument("an aspect ratio is positive");
}

void require_lens(const Lens& lens)
{
    require_angle(lens.fovy_degrees, lens.aspect);
    if (!(lens.near_plane > 0 && lens.far_plane > lens.near_plane))
        throw std::invalid_argument("the far plane lies beyond the near one, and that before the eye");
}

// Depth becomes (scale · z + offset) / -z.
glm::mat4 matrix_of(const Lens& lens, double scale, double offset)
{
    // Half the height of the picture at distance 1. In double: near 90° a step of a float changes the tangent a lot.
    const double half_height = std::tan(0.5 * lens.fovy_degrees * degree);
    return {
        {1 / (lens.aspect * half_height), 0, 0, 0}, {0, 1 / half_height, 0, 0}, {0, 0, scale, -1}, {0, 0, offset, 0}};
}

// 0 for an infinite far plane.
double plane_quotient(const Lens& lens) { return double{lens.near_plane} / lens.far_plane; }

}

glm::mat4 perspective_matrix(const Lens& lens)
{
    require_lens(lens);
    const double quotient = plane_quotient(lens);
    return matrix_of(lens, -(1 + quotient) / (1 - quotient), -2.0 * lens.near_plane / (1 - quotient));
}

glm::mat4 reversed_perspective_matrix(const Lens& lens)
{
    require_lens(lens);
    const double quotient = plane_quotient(lens);
    return matrix_of(lens, quotient / (1 - quotient), lens.near_plane / (1 - quotient));
}

// Half the width at distance 1 over the aspect is half the height.
float vertical_field_of_view(float fovx_degrees, float aspect)
{
    require_angle(fovx_degrees, aspect);
    const double half_width = std::tan(0.5 * fovx_degrees * degree);
    return static_cast<float>(2 * std::atan(half_width / aspect) / degree);
}

}
