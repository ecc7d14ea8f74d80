#include <umbral/projections/perspective.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

// With at least 64 bits, each entry rounded to float once. The cotangent comes from the angle that is left to 180°, or
// from cosine and sine; the depths from what becomes of the two planes.

namespace umbral::projections {
namespace {

using Wide = long double;

constexpr Wide degree = std::numbers::pi_v<Wide> / 180;

Wide half_tangent(float degrees)
{
    const Wide left = (180 - Wide(degrees)) / 2 * degree;  // exact before it becomes radians
    const Wide half = Wide(degrees) / 2 * degree;
    return degrees > 90 ? std::cos(left) / std::sin(left) : std::sin(half) / std::cos(half);
}

void require(bool condition)
{
    if (!condition) throw std::invalid_argument("no lens");
}

// The depth that stands at near and far: solved for scale and offset, with the far plane's equation divided by f.
glm::mat4 matrix_of(const Lens& lens, int at_near, int at_far)
{
    require(lens.fovy_degrees > 0 && lens.fovy_degrees < 180 && lens.aspect > 0);
    require(lens.near_plane > 0 && lens.far_plane > lens.near_plane);
    const Wide n = lens.near_plane;
    const Wide f = lens.far_plane;
    const Wide offset = std::isinf(lens.far_plane) ? n * (at_near - at_far) : (at_near - at_far) * n * (f / (f - n));
    const Wide scale = std::isinf(lens.far_plane) ? Wide(-at_far) : (at_near * n - at_far * f) / (f - n);
    glm::mat4 matrix(0);
    matrix[0][0] = static_cast<float>(1 / (half_tangent(lens.fovy_degrees) * lens.aspect));
    matrix[1][1] = static_cast<float>(1 / half_tangent(lens.fovy_degrees));
    matrix[2][2] = static_cast<float>(scale);
    matrix[2][3] = -1;
    matrix[3][2] = static_cast<float>(offset);
    return matrix;
}

}

glm::mat4 perspective_matrix(const Lens& lens) { return matrix_of(lens, -1, 1); }

glm::mat4 reversed_perspective_matrix(const Lens& lens) { return matrix_of(lens, 1, 0); }

float vertical_field_of_view(float fovx_degrees, float aspect)
{
    require(fovx_degrees > 0 && fovx_degrees < 180 && aspect > 0);
    return static_cast<float>(2 * std::atan2(half_tangent(fovx_degrees), Wide(aspect)) / degree);
}

}
