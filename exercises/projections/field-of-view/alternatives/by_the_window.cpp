// alternative: the window at the near plane first, then the entries of a frustum's matrix
#include <numbers>
#include <stdexcept>
#include <umbral/projections/perspective.hpp>

namespace umbral::projections {
namespace {

struct Window {
    double right;
    double top;
};

Window window_of(const Lens& lens)
{
    const bool right_angle = lens.fovy_degrees > 0 && lens.fovy_degrees < 180 && lens.aspect > 0;
    const bool right_planes = lens.near_plane > 0 && lens.far_plane > lens.near_plane;
    if (!right_angle || !right_planes) throw std::invalid_argument("Lens: out of range");
    const double top = lens.near_plane * std::tan(double{lens.fovy_degrees} * std::numbers::pi / 360);
    return {lens.aspect * top, top};
}

glm::dmat4 symmetric(const Lens& lens)
{
    const Window window = window_of(lens);
    glm::dmat4 matrix(0.0);
    matrix[0][0] = lens.near_plane / window.right;
    matrix[1][1] = lens.near_plane / window.top;
    matrix[2][3] = -1;
    return matrix;
}

}

glm::mat4 perspective_matrix(const Lens& lens)
{
    glm::dmat4 matrix = symmetric(lens);
    const double n = lens.near_plane;
    const double f = lens.far_plane;
    matrix[2][2] = std::isinf(f) ? -1 : -(f + n) / (f - n);
    matrix[3][2] = std::isinf(f) ? -2 * n : -2 * f * n / (f - n);
    return glm::mat4(matrix);
}

glm::mat4 reversed_perspective_matrix(const Lens& lens)
{
    glm::dmat4 matrix = symmetric(lens);
    const double n = lens.near_plane;
    const double f = lens.far_plane;
    matrix[2][2] = std::isinf(f) ? 0 : n / (f - n);
    matrix[3][2] = std::isinf(f) ? n : f * n / (f - n);
    return glm::mat4(matrix);
}

float vertical_field_of_view(float fovx_degrees, float aspect)
{
    const Window window = window_of({fovx_degrees, aspect, 1, 2});
    return static_cast<float>(std::atan2(window.top, double{aspect}) * 360 / std::numbers::pi);
}

}
