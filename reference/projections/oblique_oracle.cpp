#include <umbral/projections/oblique.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

// With at least 64 bits, rounded to float once. The shear is found from what becomes of a ray, not from the formula.

namespace umbral::projections {
namespace {

using Wide = long double;
using WideVector = glm::vec<3, Wide>;

constexpr Wide degree = std::numbers::pi_v<Wide> / 180;

// From a point of the view plane away from the viewer, to what appears in the same place one unit farther.
WideVector ray_of(const Lean& lean)
{
    const Wide angle = std::remainder(Wide(lean.angle_degrees), Wide(360)) * degree;
    return {-lean.foreshortening * std::cos(angle), -lean.foreshortening * std::sin(angle), -1};
}

}

float foreshortening_of(float alpha_degrees)
{
    if (!(alpha_degrees > 0 && alpha_degrees <= 90)) throw std::invalid_argument("no angle");
    if (alpha_degrees == 90) return 0;
    const Wide angle = Wide(alpha_degrees) * degree;
    return static_cast<float>(std::cos(angle) / std::sin(angle));
}

glm::mat4 oblique_shear(const Lean& lean)
{
    const WideVector ray = ray_of(lean);  // goes to (0, 0, -1)
    glm::mat4 matrix(1);
    matrix[2][0] = static_cast<float>(ray.x);
    matrix[2][1] = static_cast<float>(ray.y);
    return matrix;
}

glm::mat4 oblique_matrix(const ViewVolume& box, const Lean& lean)
{
    const WideVector ray = ray_of(lean);
    const WideVector low(box.left, box.bottom, -box.near_plane);
    const WideVector high(box.right, box.top, -box.far_plane);
    const WideVector half = (high - low) / Wide(2);
    const WideVector middle = (high + low) / Wide(2);
    glm::mat4 matrix(1);
    for (int axis = 0; axis < 3; ++axis) {
        matrix[axis][axis] = static_cast<float>(1 / half[axis]);
        matrix[3][axis] = static_cast<float>(-middle[axis] / half[axis]);
    }
    matrix[2][0] = static_cast<float>(ray.x / half.x);
    matrix[2][1] = static_cast<float>(ray.y / half.y);
    return matrix;
}

glm::vec3 projector_direction(const Lean& lean)
{
    const WideVector ray = ray_of(lean);
    return glm::vec3(ray / std::sqrt(dot(ray, ray)));
}

}
